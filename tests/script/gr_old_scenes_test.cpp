// Scenes in the manner of the course projects that this language comes from run unmodified.
#include "gr_script.h"

#include <doctest/doctest.h>

using namespace rt;
using rt::test::runScene;
using rt::test::SceneFolder;
using rt::test::ScriptRun;

TEST_CASE("a puppet of joints and scaled spheres") {
    const ScriptRun run = runScene(R"(
red = gr.material({1.0, 0.0, 0.0}, {0.1, 0.1, 0.1}, 10)
blue = gr.material({0.0, 0.0, 1.0}, {0.1, 0.1, 0.1}, 10)

rootnode = gr.node('root')
torso = gr.sphere('torso')
rootnode:add_child(torso)
torso:set_material(red)
torso:scale(0.5, 1.0, 0.5);

neck = gr.joint('neckjoint', {-20, 10, 45}, {0, 0, 0})
rootnode:add_child(neck)
neck:translate(0, 0.9, 0)
head = gr.sphere('head')
neck:add_child(head)
head:scale(0.25, 0.25, 0.25)
head:rotate('y', -20.0)
head:set_material(blue)
rootnode:rotate('x', 15)

white_light = gr.light({-100.0, 150.0, 400.0}, {0.9, 0.9, 0.9}, {1, 0, 0})
orange_light = gr.light({400.0, 100.0, 150.0}, {0.7, 0.0, 0.7}, {0, 0, 0})
gr.render(rootnode, 'puppet.png', 256, 256,
	  {0, 0, 800}, {0, 0, -800}, {0, 1, 0}, 50,
	  {0.3, 0.3, 0.3}, {white_light, orange_light})
)");
    REQUIRE(run.error == "");
    CHECK(run.scene().nodes.size() == 4);
    CHECK(run.scene().renders.at(0).lights.size() == 2);
    CHECK(run.scene().nodes[2].latest().children.size() == 1);
    CHECK(run.diagnostics.total() == 1);  // the falloff of zeros
}

TEST_CASE("a hierarchy instanced as a graph, with the materials of the oldest scenes") {
    const ScriptRun run = runScene(R"(
-- A pillar used six times, itself of three parts.
stone = gr.material({0.8, 0.7, 0.7}, {0.0, 0.0, 0.0}, 0)
grass = gr.material({0.1, 0.7, 0.1}, {0.0, 0.0, 0.0}, 0)
scene = gr.node('scene')
scene:rotate('X', 23)
inst = gr.node('inst')
arc = gr.node('arc')
inst:add_child(arc)
arc:translate(0,0,-10)
p1 = gr.nh_box('p1', {0, 0, 0}, 1)
arc:add_child(p1)
p1:set_material(stone)
p1:scale(0.8, 4, 0.8)
p1:translate(-2.4, 0, -0.4)
s = gr.nh_sphere('s', {0,0,0}, 1)
arc:add_child(s)
s:set_material(stone)
s:scale(4, 0.6, 0.6)
s:translate(0, 4, 0)
for i = 1, 6 do
   an_arc = gr.node('arc' .. tostring(i))
   an_arc:rotate('Y', (i-1) * 60)
   scene:add_child(an_arc)
   an_arc:add_child(inst)
end
plane = gr.mesh('plane', { { -1, 0, -1 }, { 1, 0, -1 }, { 1, 0, 1 }, { -1, 0, 1 } },
                         { {3, 2, 1, 0} })
scene:add_child(plane)
plane:set_material(grass)
plane:scale(30, 30, 30)
l1 = gr.light({200,200,400}, {0.8, 0.8, 0.8}, {1, 0, 0})
l2 = gr.light({0, 5, -20}, {0.4, 0.4, 0.8}, {1, 0, 0})
gr.render(scene, 'images/instance.png', 256, 256,
	  {0, 2, 30}, {0, 0, -1}, {0, 1, 0}, 50,
	  {0.4, 0.4, 0.4}, {l1, l2})
)");
    REQUIRE(run.error == "");
    CHECK(run.diagnostics.total() == 0);
    CHECK(run.scene().renders.at(0).output == "images/instance.png");
}

TEST_CASE("meshes by name, by file and from a reader that the scene brings along") {
    const SceneFolder folder;
    folder.write("buckyball.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.write("Assets/Model/cow.obj");
    folder.write("readobj.lua", R"(
module_loaded = true
function readobj(filename)
   verts, faces = {}, {}
   for line in io.lines(filename) do
      local _, _, kind, a, b, c = string.find(line, '^(%a)%s+(%S+)%s+(%S+)%s+(%S+)')
      if kind == 'v' then table.insert(verts, {a, b, c}) end
      if kind == 'f' then
         local face = {}
         for index in string.gfind(line, '%d+') do table.insert(face, tonumber(index) - 1) end
         table.insert(faces, face)
      end
   end
   return verts, faces
end
)");
    const ScriptRun run = runScene(folder, R"(
require('readobj')
bucky = gr.mesh('buckyball', readobj('buckyball.obj'))
cow = gr.mesh('cow', 'cow.obj')
scene = gr.node('scene')
scene:add_child(bucky) scene:add_child(cow)
m = gr.material({1, 1, 1}, {0, 0, 0}, 1)
bucky:set_material(m) cow:set_material(m)
gr.render(scene, 'cows.png', 256, 256, {0,0,800}, {0,0,-800}, {0,1,0}, 50, {.3,.3,.3},
          {gr.light({0,0,0}, {1,1,1}, {1,0,0})})
)");
    REQUIRE(run.error == "");
    const auto& mesh = std::get<MeshTableDesc>(run.scene().geometries.at(0).shape);
    CHECK(mesh.vertices == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    CHECK(mesh.corners == std::vector<Index>{0, 1, 2});
    CHECK(std::get<MeshFileDesc>(run.scene().geometries.at(1).shape).path ==
          (folder.path() / "Assets/Model/cow.obj").string());
}

TEST_CASE("the later dialect: lens, textures, sphere lights and appearance on edges") {
    const SceneFolder folder;
    folder.write("Texture/wood.png");
    folder.write("Bump/brick.png");
    folder.write("Meshes/bunny.obj");
    const ScriptRun run = runScene(folder, R"(
scene_root = gr.node('root')
wood = gr.texture('wood.png', {0.2, 0.2, 0.2}, 20)
brick = gr.bumpmap('brick.png')
gold = gr.material({0.9, 0.8, 0.4}, {0.8, 0.8, 0.4}, 25)
bunny = gr.mesh('bunny.obj', 'bunny')
for i = 1, 20 do
    local place = gr.node('place' .. i)
    place:translate(i, 0, 0)
    place:add_child(bunny, i % 2 == 0 and gold or nil, wood, brick)
    scene_root:add_child(place)
end
ball = gr.nh_sphere('ball', {0, 1, 0}, 1)
ball:set_reflection(0.3) ball:set_refraction(1.5, 0.1)
scene_root:add_child(ball, gold)
light = gr.light(0, 10, 0, 1, 1, 1, 1, 0, 0, 0.5, 0.1)
lens = gr.focal(11, 2, 0.3)
for frame = 1, 3 do
    ball:translate(0, 0.1, 0)
    gr.render(scene_root, 'frames/f' .. frame .. '.png', 160, 90, {0, 2, 12}, {0, 0, -1}, {0, 1, 0},
              50, {0.2, 0.2, 0.2}, {light}, lens)
end
)");
    REQUIRE(run.error == "");
    CHECK(run.diagnostics.total() == 0);
    CHECK(run.scene().geometries.size() == 2);
    CHECK(run.scene().renders.size() == 3);
    CHECK(run.scene().renders[0].camera.focal->lensRadius == 0.3);
    CHECK(run.scene().renders[0].lights.at(0).light.brightness == 0.1);
}
