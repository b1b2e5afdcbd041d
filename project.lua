-- What ./Project renders when it is given no scene.
package.path = 'scenes/?.lua;' .. package.path
dofile('scenes/room.lua')
