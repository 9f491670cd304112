-- All prefabs on one page. Drag things with the mouse; left and right drive the car, down brakes it.
local world, camera, car, elevator, windmill, grip
local time, floor, broken = 0, 0, 0
local strung = {} -- prefabs whose ropes and rods are no bodies

local function color(r, g, b) return { color = { r, g, b } } end

function cairn.load()
    world = cairn.physics.new_world{}
    camera = cairn.camera.new{ x = 0, y = 7.4, height = 19 }
    local prefab, ground = cairn.prefab, color(0.36, 0.42, 0.38)
    -- The ground has a gap from x = -2 to 6 that the bridge spans.
    world:add_box{ type = "static", x = -11, y = -1, width = 18, height = 2, data = ground }
    world:add_box{ type = "static", x = 12.5, y = -1, width = 13, height = 2, data = ground }
    world:add_box{ type = "static", x = 2, y = -3, width = 10, height = 1, data = ground }
    prefab.bridge(world, { x = -2, y = -0.1, to_x = 6, to_y = -0.1, planks = 16,
                           data = color(0.62, 0.45, 0.28) })

    car = prefab.vehicle(world, { x = -6, y = 1, data = color(0.80, 0.30, 0.25) })
    elevator = prefab.elevator(world, { x = -15, y = 0.2, floors = { 0, 4, 8 },
                                        data = color(0.35, 0.50, 0.70) })
    world:add_box{ x = -15, y = 0.7, width = 1, height = 1, density = 20, data = color(0.87, 0.66, 0.40) }
    windmill = prefab.windmill(world, { x = -10, y = 12, sail_length = 2.2, data = color(0.86, 0.84, 0.76) })
    prefab.gear_train(world, { x = -4.6, y = 12.4, radii = { 0.6, 1.2, 0.4, 0.8 }, motor_speed = 2,
                               max_motor_torque = 100, data = color(0.60, 0.62, 0.66) })
    strung[1] = prefab.pulley_lift(world, { x = -8.5, y = 5, distance = 3, travel = 1.5, width = 1.2, rope = 3,
                                            left_density = 4, right_density = 3, data = color(0.45, 0.60, 0.45) })
    prefab.rope(world, { x = -3, y = 9, to_x = 3, to_y = 9, length = 8, data = color(0.75, 0.62, 0.40) })
    prefab.chain(world, { x = 5, y = 13, links = 9, data = color(0.55, 0.57, 0.60) })
    strung[2] = prefab.pendulum(world, { x = 8.5, y = 13, bobs = 2, rod = 1.6, radius = 0.35, angle = 2,
                                         density = 2, data = color(0.70, 0.45, 0.65) })
    prefab.blob(world, { x = 7.4, y = 4, data = color(0.45, 0.72, 0.62) })
    prefab.brick_wall(world, { x = 13.6, y = 0, columns = 5, courses = 12, data = color(0.72, 0.40, 0.32) })
    prefab.ragdoll(world, { x = 0, y = 5.5, scale = 1.4, data = color(0.90, 0.72, 0.58) })
    prefab.ragdoll(world, { x = 13.6, y = 3.05, scale = 1.2, spring_frequency = 4,
                            data = color(0.58, 0.70, 0.90) })
    -- The wrecking ball.
    strung[3] = prefab.pendulum(world, { x = 11.4, y = 12, rod = 10, radius = 0.7, angle = -0.75, density = 20,
                                         data = color(0.30, 0.32, 0.36) })
    car:drive(4)
    cairn.timer.after(3, function() car:brake() end)
end

function cairn.update(dt) -- dt is always 1/60 s
    time = time + dt
    if elevator:is_at(floor) and time > 4 * (floor + 1) then
        floor = (floor + 1) % 3
        elevator:send(floor)
    end
    if cairn.input.is_down("right") then car:drive(5) end
    if cairn.input.is_down("left") then car:drive(-5) end
    if cairn.input.is_down("down") then car:brake() end
    windmill:blow(6, dt)
    world:step(dt)
    for _ in world:joint_breaks() do broken = broken + 1 end
end

local function draw_strings(joint)
    local xa, ya = joint:anchor_a()
    if joint:kind() == "revolute" then
        cairn.graphics.line(xa, ya, joint:body_b():position())
    elseif joint:kind() == "pulley" then
        local p, xb, yb = joint:parameters(), joint:anchor_b()
        cairn.graphics.line(xa, ya, p.wheel_x_a, p.wheel_y_a)
        cairn.graphics.line(p.wheel_x_a, p.wheel_y_a, p.wheel_x_b, p.wheel_y_b)
        cairn.graphics.line(xb, yb, p.wheel_x_b, p.wheel_y_b)
    end
end

function cairn.draw()
    cairn.graphics.clear(0.13, 0.15, 0.18)
    camera:attach()
    cairn.graphics.set_color(0.7, 0.7, 0.7)
    cairn.graphics.set_line_width(0.05)
    for _, prefab in ipairs(strung) do
        for _, joint in ipairs(prefab:joints()) do draw_strings(joint) end
    end
    cairn.graphics.set_color(1, 1, 1)
    cairn.graphics.draw_world(world)
    camera:detach()
    local counts = ("%d bodies, %d joints, %d broken"):format(world:body_count(), world:joint_count(), broken)
    cairn.graphics.print(counts, 8, 8)
end

function cairn.mouse_pressed(x, y)
    local wx, wy = camera:to_world(x, y)
    local body = world:body_at(wx, wy)
    if body and body:type() == "dynamic" then grip = world:add_mouse_joint{ body = body, x = wx, y = wy } end
end

function cairn.mouse_moved(x, y)
    if grip and grip:is_valid() then grip:set_target(camera:to_world(x, y)) end
end

function cairn.mouse_released()
    if grip and grip:is_valid() then grip:destroy() end
    grip = nil
end
