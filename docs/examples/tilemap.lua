-- A cave drawn with the editor Tiled (maps/cave.tmx): its rock becomes bodies, its objects crates and the start.
-- Arrow keys or the left stick roll, space or the lower button jumps.
local g = cairn.graphics
local map, world, camera, ball

function cairn.load()
    map = cairn.tilemap.load("maps/cave.tmx", { scale = 1 / 16, y_up = true, filter = "nearest" }) -- a tile is a metre
    world = cairn.physics.new_world{}
    local rock = world:new_body{ type = "static", data = { visible = false } }
    for _, rectangle in ipairs(map:solids("ground", "solid")) do rock:add_box(rectangle) end
    for _, object in ipairs(map:objects("things")) do
        if object.class == "crate" then
            world:add_box{ x = object.x, y = object.y, width = object.width, height = object.height }
        elseif object.name == "start" then
            ball = world:add_circle{ x = object.x, y = object.y, radius = 0.4, friction = 1, angular_damping = 2,
                data = { color = { 0.9, 0.85, 0.8 } } }
        end
    end
    local width, height = map:size()
    camera = cairn.camera.new{ height = 12, follow_rate = 5 }
    camera:set_bounds(0, 0, width, height)
    camera:set_position(ball:position())

    cairn.input.bind("left", { "left", "a", "gamepad_left_x-", "gamepad_dpad_left" })
    cairn.input.bind("right", { "right", "d", "gamepad_left_x+", "gamepad_dpad_right" })
    cairn.input.bind("jump", { "space", "up", "gamepad_a" })
end

function cairn.update(dt)
    ball:apply_torque(-4 * cairn.input.axis("left", "right"))
    if cairn.input.was_pressed("jump") then ball:apply_impulse_to_center(0, 4) end
    world:step(dt)
    camera:follow(ball:position())
    camera:update(dt)
end

function cairn.draw()
    camera:attach()
    map:draw()
    g.draw_world(world)
    camera:detach()
end
