-- Breakout in which what breaks falls down. Mouse, arrows or a gamepad move the paddle; a click, space or A serves.
-- R starts again, Escape leaves.
local g, input = cairn.graphics, cairn.input

local BALL, RUBBLE = 4, 8 -- categories; bricks are 2
local REACH = 6.4         -- m; how far the paddle's middle gets from that of the box

breakout = {} -- global, so that tests can look at it
local world, level, camera, rules, target

local function place_ball()
    local x, y = level:spawn("ball")
    breakout.ball = world:add_circle{ x = x, y = y, radius = 0.22, friction = 0, restitution = 1, gravity_scale = 0,
        lock_rotation = true, allow_sleep = false, categories = BALL, mask = ~RUBBLE, data = { color = { 1, 0.95, 0.8 } } }
    breakout.is_served = false
end

local function start()
    if world then world:destroy() end
    world = cairn.physics.new_world{ restitution_speed = 0.1, hit_speed = 0.1 }
    level:build(world)
    breakout.score, breakout.lives, breakout.bricks, breakout.outcome = 0, rules.lives, 0, nil
    for _, body in ipairs(level:bodies()) do
        if body.data.kind == "brick" then breakout.bricks = breakout.bricks + 1 end
    end
    target = 0
    place_ball()
end

function cairn.load()
    level = cairn.level.load "levels/wall.lua"
    local x, y, height = level:camera()
    camera = cairn.camera.new{ x = x, y = y, height = height }
    rules = level:data()
    input.bind("left", { "left", "a", "gamepad_left_x-", "gamepad_dpad_left" })
    input.bind("right", { "right", "d", "gamepad_left_x+", "gamepad_dpad_right" })
    input.bind("serve", { "space", "mouse_left", "gamepad_a" })
    start()
end

local function finish(outcome)
    breakout.outcome = outcome
    cairn.result{ outcome = outcome, level = "wall", score = breakout.score }
end

local function serve()
    if breakout.outcome then return end
    breakout.is_served = true
    breakout.ball:set_linear_velocity(cairn.random.number(-3, 3), rules.speed)
end

-- The farther from the paddle's middle, the flatter it leaves.
local function leave_paddle(paddle)
    local off = (breakout.ball:position() - paddle:position()) / 1.02
    local angle = math.max(-1, math.min(1, off)) * 1.1
    breakout.ball:set_linear_velocity(rules.speed * math.sin(angle), rules.speed * math.cos(angle))
    cairn.audio.play("sounds/bounce.wav", { volume = 0.5 })
end

local function break_brick(brick)
    breakout.score = breakout.score + brick.data.points
    breakout.bricks = breakout.bricks - 1
    cairn.audio.play("sounds/brick.wav", { pitch = 0.8 + brick.data.points / 100, volume = 0.6 })
    local x, y = breakout.ball:position()
    brick.data.kind = "rubble"
    for _, piece in ipairs(brick:fracture{ x = x, y = y, pieces = 6, seed = breakout.bricks, release = true }) do
        for _, shape in ipairs(piece:shapes()) do shape:set_filter(RUBBLE, ~BALL, 0) end
        local mass = piece:mass()
        piece:apply_impulse_to_center(cairn.random.number(-1.5, 1.5) * mass, cairn.random.number(0, 2) * mass)
    end
    if breakout.bricks == 0 then finish("won") end
end

local function lose_ball()
    breakout.ball:destroy()
    breakout.lives = breakout.lives - 1
    cairn.audio.play("sounds/lose.wav")
    if breakout.lives == 0 then
        finish("lost")
    else
        place_ball()
    end
end

function cairn.update(dt)
    local paddle, ball = level:body("paddle"), breakout.ball
    target = math.max(-REACH, math.min(REACH, target + 12 * dt * input.axis("left", "right")))
    paddle:set_linear_velocity((target - paddle:position()) / dt, 0) -- there with the next step
    if not breakout.is_served and ball:is_valid() then
        ball:set_transform(target, 1.1, 0)
        if input.was_pressed("serve") then serve() end
    end
    world:step(dt)

    for _, a, b in world:events("begin") do
        local other = a == ball and b or b == ball and a
        if other and other:is_valid() and breakout.is_served then
            if other == paddle then
                leave_paddle(paddle)
            elseif other.data.kind == "brick" then
                break_brick(other)
            else
                cairn.audio.play("sounds/bounce.wav", { pitch = 1.4, volume = 0.25 })
            end
        end
    end
    for kind, _, visitor in world:sensor_events() do
        if kind == "begin" and visitor:is_valid() then
            if visitor == breakout.ball then lose_ball() else visitor:destroy() end
        end
    end
    if breakout.is_served and ball:is_valid() then -- always as fast, and never level for ever
        local vx, vy = ball:linear_velocity()
        if math.abs(vy) < 1.5 then vy = vy < 0 and -1.5 or 1.5 end
        local factor = rules.speed / math.sqrt(vx * vx + vy * vy)
        ball:set_linear_velocity(vx * factor, vy * factor)
    end
end

function cairn.mouse_moved(x, y) target = camera:to_world(x, y) end

function cairn.draw()
    g.clear(0.10, 0.11, 0.15)
    camera:attach()
    g.draw_world(world)
    camera:detach()
    g.set_color(1, 1, 1)
    g.set_font(g.new_font(26))
    g.print(tostring(breakout.score), 24, 8)
    g.print(("Balls %d"):format(breakout.lives), 936, 8, "right")
    if breakout.outcome then
        g.print(breakout.outcome == "won" and "All gone. R: again" or "Lost. R: again", 480, 420, "center")
    elseif not breakout.is_served then
        g.print("Click to serve", 480, 420, "center")
    end
end

function cairn.key_pressed(key)
    if key == "r" then start() end
    if key == "escape" then cairn.quit() end
end

function cairn.gamepad_pressed(_, button)
    if button == "start" then start() end
end
