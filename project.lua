-- What ./Project renders when it is given no scene.
dofile('scenes/first_light.lua')
