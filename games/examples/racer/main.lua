-- A race over three laps, seen from above.
-- Arrows, WASD, a gamepad, or the mouse: hold its button where the car shall go. R starts again, Escape leaves.
local g, input = cairn.graphics, cairn.input

-- Accelerations in m/s^2. What the tyres do not hold is a skid.
local ENGINE, BRAKE, DRAG, GRIP, TURN = 14, 24, 0.55, 26, 3.2
local COLORS = { { 0.90, 0.25, 0.20 }, { 0.20, 0.45, 0.85 }, { 0.95, 0.75, 0.20 }, { 0.35, 0.70, 0.35 } }
local GATES = 6

race = { cars = {} } -- global, so that tests can look at it
local world, level, camera, road, smoke, hum, banner

local function clamp(value, low, high) return math.max(low, math.min(high, value)) end

local function start()
    if world then world:destroy() end
    world = cairn.physics.new_world{}
    level:build(world)
    race.cars, race.places, banner = {}, 0, nil
    for i, color in ipairs(COLORS) do
        local x, y, angle = level:spawn("start-" .. i)
        local body = world:add_box{ x = x, y = y, angle = angle, width = 2, height = 1, radius = 0.1,
            density = 2, friction = 0.3, restitution = 0.2, allow_sleep = false, data = { color = color } }
        body.data.car = { body = body, gate = 1, lap = 0, skill = 1 - 0.04 * i, stuck = 0, aim = 1 }
        race.cars[i] = body.data.car
    end
end

function cairn.load()
    level = cairn.level.load "levels/ring.lua"
    local _, _, height = level:camera()
    camera = cairn.camera.new{ height = height }
    road = level:data()
    smoke = cairn.particles.new{ max_count = 400, lifetime = 0.5, lifetime_max = 0.9, size = 0.6, size_end = 1.6,
        speed_max = 0.5, colors = { { 0.9, 0.9, 0.9, 0.35 }, { 0.9, 0.9, 0.9, 0 } } }
    input.bind("faster", { "up", "w", "gamepad_right_trigger", "gamepad_a" })
    input.bind("slower", { "down", "s", "gamepad_left_trigger", "gamepad_b" })
    input.bind("left", { "left", "a", "gamepad_left_x-", "gamepad_dpad_left" })
    input.bind("right", { "right", "d", "gamepad_left_x+", "gamepad_dpad_right" })
    start()
end

-- The tyres: the engine acts along the car, and they hold it across, as far as their grip goes.
local function drive(car, throttle, steer, dt)
    local body = car.body
    local forward_x, forward_y = math.cos(body:angle()), math.sin(body:angle())
    local vx, vy = body:linear_velocity()
    local along = vx * forward_x + vy * forward_y
    local across = vy * forward_x - vx * forward_y
    local push = throttle * (throttle * along < 0 and BRAKE or ENGINE) - DRAG * along
    local hold = -clamp(across / dt, -GRIP, GRIP)
    local mass = body:mass()
    body:apply_force_to_center(mass * (push * forward_x - hold * forward_y), mass * (push * forward_y + hold * forward_x))
    local turn = steer * TURN * clamp(along / 5, -1, 1)
    body:apply_torque(body:inertia() * (turn - body:angular_velocity()) * 10)
    car.speed = along
    if math.abs(across) > 3 then
        smoke:emit(1, body:position())
    end
end

-- How far to turn towards a place, from -1 to 1, and by what angle it lies off.
local function steer_to(car, x, y)
    local dx, dy = car.body:to_local(x, y)
    local off = math.atan(dy, dx)
    return clamp(off * 2, -1, 1), math.abs(off)
end

local function drive_other(car, dt)
    local line, x, y = road.line, car.body:position()
    while true do -- the next point of the line that is far enough ahead
        local point = line[car.aim]
        if (point[1] - x) ^ 2 + (point[2] - y) ^ 2 > 36 then break end
        car.aim = car.aim % #line + 1
    end
    local steer, off = steer_to(car, line[car.aim][1], line[car.aim][2])
    car.stuck = (math.abs(car.speed or 0) < 1) and car.stuck + dt or math.max(0, car.stuck - dt)
    if car.stuck > 1 then
        return drive(car, -1, -steer, dt) -- back out of the wall
    end
    drive(car, off > 0.5 and 0.3 or car.skill, steer, dt)
end

local function drive_player(car, dt)
    local throttle, steer = input.axis("slower", "faster"), input.axis("right", "left")
    if input.is_mouse_down("left") then
        steer = steer_to(car, camera:to_world(input.mouse_position()))
        throttle = 1
    end
    drive(car, throttle, steer, dt)
end

local function pass(car, gate)
    if gate ~= car.gate then return end
    car.gate = gate % GATES + 1
    if gate < GATES then return end
    car.lap = car.lap + 1
    if car == race.cars[1] then cairn.audio.play("sounds/lap.wav") end
    if car.lap ~= road.laps then return end
    race.places = race.places + 1
    if car == race.cars[1] or race.places == #race.cars - 1 then
        local place = car == race.cars[1] and race.places or #race.cars
        banner = banner or ("Place %d. R: again"):format(place)
        cairn.result{ outcome = place == 1 and "won" or "lost", level = "ring", score = place }
    end
end

function cairn.update(dt)
    for i, car in ipairs(race.cars) do
        if i == 1 then drive_player(car, dt) else drive_other(car, dt) end
    end
    world:step(dt)
    for kind, sensor, visitor in world:sensor_events() do
        if kind == "begin" and visitor.data.car then
            pass(visitor.data.car, tonumber(sensor.data.name:match("%d+")))
        end
    end
    local me = race.cars[1]
    for _, a, b, impulse in world:events("hit") do
        if a == me.body or b == me.body then
            cairn.audio.play("sounds/bump.wav", { volume = clamp(impulse / 20, 0, 1) })
            camera:shake(clamp(impulse / 60, 0, 0.4))
        end
    end
    hum = hum or cairn.audio.play("sounds/engine.wav", { loop = true, volume = 0.1 })
    cairn.audio.set_voice_volume(hum, 0.05 + 0.01 * math.abs(me.speed))
    smoke:update(dt)
    camera:follow(0, 0)
    camera:update(dt)
end

function cairn.draw()
    g.clear(0.33, 0.47, 0.28)
    camera:attach()
    g.set_color(0.85, 0.84, 0.80)
    g.set_line_width(road.width + 0.6)
    g.polygon("line", road.line)
    g.set_color(0.28, 0.28, 0.31)
    g.set_line_width(road.width)
    g.polygon("line", road.line)
    local x, y, angle = level:trigger("gate-" .. GATES):transform()
    g.push()
    g.translate(x, y)
    g.rotate(angle)
    for row = 0, 6 do -- the finish, chequered
        for column = 0, 1 do
            local shade = (row + column) % 2
            g.set_color(shade, shade, shade)
            g.rectangle("fill", 0.6 * column - 0.6, (row - 3.5) * road.width / 7, 0.6, road.width / 7)
        end
    end
    g.pop()
    g.set_color(1, 1, 1)
    smoke:draw()
    g.draw_world(world)
    camera:detach()
    local me = race.cars[1]
    g.set_color(1, 1, 1)
    g.set_font(g.new_font(28))
    g.print(("Lap %d of %d"):format(math.min(me.lap + 1, road.laps), road.laps), 24, 18)
    g.print(("%.0f km/h"):format(math.abs(me.speed or 0) * 3.6), 1256, 18, "right")
    if banner then g.print(banner, 640, 330, "center") end
end

function cairn.key_pressed(key)
    if key == "r" then start() end
    if key == "escape" then cairn.quit() end
end

function cairn.gamepad_pressed(_, button)
    if button == "start" then start() end
end
