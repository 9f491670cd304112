-- A stack of crates. Click a crate to kick it.
local world, camera

function cairn.load()
    world = cairn.physics.new_world{ gravity_y = -10 }
    camera = cairn.camera.new{ x = 0, y = 5, height = 14 } -- metres
    world:add_box{ type = "static", y = -0.5, width = 40, height = 1 }
    for i = 1, 10 do
        world:add_box{ y = i - 0.5, width = 1, height = 1, data = { color = { 0.9, 0.6, 0.2 } } }
    end
end

function cairn.update(dt) -- dt is always 1/60 s
    world:step(dt)
end

function cairn.draw()
    camera:attach()
    cairn.graphics.draw_world(world)
    camera:detach()
    cairn.graphics.print(("%d awake"):format(world:awake_count()), 8, 8)
end

function cairn.mouse_pressed(x, y)
    local body = world:body_at(camera:to_world(x, y))
    if body then body:apply_impulse_to_center(6, 4) end
end
