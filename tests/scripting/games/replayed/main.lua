-- A box that is kicked by clicks, in a direction that chance decides.
local world = cairn.physics.new_world{}
local camera = cairn.camera.new{ height = 10 }
world:add_box{ type = "static", y = -0.5, width = 40, height = 1 }
local box = world:add_box{ y = 2, width = 1, height = 1 }

function cairn.update(dt)
    world:step(dt)
    local x = box:position()
    cairn.result{ outcome = "measured", score = math.floor(x * 1000) }
end

function cairn.mouse_pressed(x, y)
    local wx, wy = camera:to_world(x, y)
    box:apply_impulse(cairn.random.number(-3, 3), 4, wx, wy)
end

function cairn.draw()
    camera:attach()
    cairn.graphics.draw_world(world)
    camera:detach()
    cairn.graphics.print("kick it", 10, 10)
end
