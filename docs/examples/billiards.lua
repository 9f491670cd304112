-- Billiards, seen from above: drag back from the white ball and let go. R racks the balls anew.
-- There is no gravity; rolling balls are slowed down by their damping, and a pocket is a sensor.
local WIDTH, HEIGHT, RADIUS = 2.54, 1.27, 0.04
local COLORS = { { 0.9, 0.75, 0.2 }, { 0.25, 0.4, 0.8 }, { 0.8, 0.25, 0.2 }, { 0.5, 0.3, 0.6 }, { 0.2, 0.55, 0.35 } }
local world, camera, white, aim, sunk, shots
local pockets = {}

local function add_ball(x, y, color)
    return world:add_circle{
        x = x, y = y, radius = RADIUS, density = 34, friction = 0.1, restitution = 0.95,
        linear_damping = 0.6, angular_damping = 0.6, data = { color = color, is_ball = true },
    }
end

local function add_table()
    local cloth = { color = { 0.15, 0.3, 0.22 } }
    local x, y, gap = WIDTH / 2, HEIGHT / 2, 0.08
    pockets = {}
    for side = -1, 1, 2 do
        for half = -1, 1, 2 do
            world:add_box{ type = "static", x = half * x / 2, y = side * (y + 0.05), width = x - 2 * gap, height = 0.1,
                restitution = 0.8, data = cloth }
        end
        world:add_box{ type = "static", x = side * (x + 0.05), width = 0.1, height = 2 * y - 2 * gap,
            restitution = 0.8, data = cloth }
        for column = -1, 1 do
            pockets[#pockets + 1] = world:add_circle{ type = "static", x = column * (x + 0.03), y = side * (y + 0.05),
                radius = 0.07, sensor = true }
        end
    end
end

function cairn.load()
    camera = cairn.camera.new{ height = 1.8 }
    if world then world:destroy() end
    world = cairn.physics.new_world{ gravity_y = 0, restitution_speed = 0.05 }
    aim, sunk, shots = nil, 0, 0
    add_table()
    white = add_ball(-WIDTH / 4, 0, { 0.95, 0.95, 0.9 })
    for row = 0, 4 do
        for i = 0, row do
            add_ball(WIDTH / 4 + row * RADIUS * 1.74, (i - row / 2) * RADIUS * 2.01, COLORS[row + 1])
        end
    end
end

local function sink(ball)
    if ball == white then
        ball:set_position(-WIDTH / 4, 0)
        ball:set_linear_velocity(0, 0)
    else
        ball:destroy()
        sunk = sunk + 1
        if sunk == 15 then cairn.result{ outcome = "won", score = shots } end
    end
end

function cairn.update(dt)
    world:step(dt)
    for kind, _, ball in world:sensor_events() do
        if kind == "begin" and ball:is_valid() and ball.data.is_ball then sink(ball) end
    end
end

function cairn.draw()
    cairn.graphics.clear(0.2, 0.42, 0.3)
    camera:attach()
    cairn.graphics.set_color(0.05, 0.05, 0.05)
    for _, pocket in ipairs(pockets) do
        local x, y = pocket:position()
        cairn.graphics.circle("fill", x, y, 0.07)
    end
    cairn.graphics.draw_world(world)  -- not the sensors
    if aim then
        local x, y = white:position()
        cairn.graphics.set_color(1, 1, 1, 0.5)
        cairn.graphics.set_line_width(0.01)
        cairn.graphics.line(x, y, 2 * x - aim.x, 2 * y - aim.y)
    end
    camera:detach()
    cairn.graphics.set_color(1, 1, 1)
    cairn.graphics.print(("%d of 15 in %d shots"):format(sunk, shots), 16, 12)
end

local function is_calm()
    return world:awake_count() == 0
end

function cairn.mouse_pressed(x, y)
    local wx, wy = camera:to_world(x, y)
    if is_calm() and world:body_at(wx, wy) == white then aim = { x = wx, y = wy } end
end

function cairn.mouse_moved(x, y)
    if aim then aim.x, aim.y = camera:to_world(x, y) end
end

function cairn.mouse_released()
    if not aim then return end
    local x, y = white:position()
    white:set_linear_velocity(6 * (x - aim.x), 6 * (y - aim.y))
    aim, shots = nil, shots + 1
end

function cairn.key_pressed(key)
    if key == "r" then cairn.load() end
end
