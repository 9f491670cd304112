-- Land softly on the green pad: arrow keys, or a gamepad.
local world, camera, ship, flame, fuel, message

local function start()
    if world then world:destroy() end
    world = cairn.physics.new_world{ gravity_y = -1.6 }
    camera = cairn.camera.new{ y = 13, height = 30 }
    local ground = {}
    for i = 0, 20 do
        local is_pad = i == 6 or i == 7
        ground[i + 1] = { 30 - 3 * i, is_pad and 2 or cairn.random.number(0, 5) }
    end
    world:add_chain{ type = "static", points = ground }
    world:add_box{ type = "static", x = 10.5, y = 2, width = 2.5, height = 0.4, data = { color = { 0.2, 0.8, 0.3 }, is_pad = true } }
    ship = world:add_polygon{
        points = { { -1, -0.8 }, { 1, -0.8 }, { 0, 1.4 } }, x = -10, y = 22, friction = 0.9, angular_damping = 1,
        data = { color = { 0.9, 0.8, 0.5 } },
    }
    ship:set_linear_velocity(3, 0)
    flame = cairn.particles.new{ lifetime = 0.5, speed = 8, spread = 0.4, size = 0.6, size_end = 0.1, blend = "add", colors = { { 1, 0.8, 0.3 }, { 1, 0.2, 0, 0 } } }
    flame:start()
    fuel, message = 10, nil
end

function cairn.load()
    cairn.input.bind("left", { "left", "gamepad_left_x-" })
    cairn.input.bind("right", { "right", "gamepad_left_x+" })
    cairn.input.bind("thrust", { "up", "gamepad_a", "gamepad_right_trigger" })
    cairn.input.bind("again", { "r", "gamepad_start" })
    start()
end

function cairn.update(dt)
    local throttle = fuel > 0 and not message and cairn.input.action_value("thrust") or 0
    fuel = math.max(fuel - throttle * dt, 0)
    local angle, force = ship:angle(), 8 * throttle * ship:mass()
    ship:apply_force_to_center(-math.sin(angle) * force, math.cos(angle) * force)
    ship:apply_torque(3 * cairn.input.axis("right", "left"))
    world:step(dt)

    flame:set_position(ship:to_world(0, -0.8))
    flame:set_direction(angle - math.pi / 2)
    flame:set_rate(80 * throttle)
    flame:update(dt)

    for _, a, b, _, _, _, _, _, speed in world:events("hit") do
        local is_pad = a.data.is_pad or b.data.is_pad
        if not message and (speed > 2 or not is_pad) then message = "That was too hard. R: again" end
    end
    if not message and not ship:is_awake() then
        message = ("Landed, with fuel for %d s. R: again"):format(fuel)
        cairn.result{ outcome = "won", score = fuel }
    end
end

function cairn.draw()
    cairn.graphics.clear(0.03, 0.03, 0.08)
    camera:attach()
    flame:draw()
    cairn.graphics.draw_world(world)
    camera:detach()
    cairn.graphics.set_color(1, 1, 1)
    cairn.graphics.print(("Fuel: %.1f s"):format(fuel), 20, 20)
    if message then cairn.graphics.print(message, 480, 200) end
end

function cairn.action_pressed(action) if action == "again" then start() end end
