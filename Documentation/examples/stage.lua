-- What the examples share: a floor, a light, a camera and some materials.
local stage = {
  red = gr.material({0.74, 0.22, 0.16}, {0.30, 0.30, 0.30}, 40),
  blue = gr.material({0.20, 0.38, 0.68}, {0.30, 0.30, 0.30}, 40),
  gold = gr.material({0.84, 0.58, 0.18}, {0.50, 0.45, 0.30}, 60),
  green = gr.material({0.32, 0.56, 0.30}, {0.25, 0.25, 0.25}, 30),
  white = gr.material({0.82, 0.81, 0.78}, {0.20, 0.20, 0.20}, 30),
  clear = gr.material({0.02, 0.02, 0.02}, {0.70, 0.70, 0.70}, 300),
  grid = gr.texture('uv_grid.png', {0.20, 0.20, 0.20}, 40),
  checks = gr.texture('checker.png', {0, 0, 0}, 1),
}

stage.sun = gr.light({-5, 8, 6}, {0.72, 0.70, 0.64}, {1, 0, 0}, 0.7)

function stage.floor(root)
  root:add_child(gr.nh_box('floor', {-60, -1, -60}, {120, 1, 120}), gr.material({0.66, 0.65, 0.62}, {0, 0, 0}, 1))
end

-- A floor of checks, half a unit wide.
function stage.board(root)
  local board = gr.mesh('board', 'ground.obj')
  board:scale(128, 128, 128)
  board:rotate('y', 30)
  root:add_child(board, nil, stage.checks)
end

function stage.show(root, lights, focal)
  gr.background({0.78, 0.79, 0.80}, {0.42, 0.54, 0.70})
  root:render('example.png', 240, 135, {0, 2.3, 7}, {0, -0.22, -1}, {0, 1, 0}, 32, {0.30, 0.30, 0.32},
              lights or {stage.sun}, focal)
end

return stage
