-- A platformer: a character that walks, jumps, pushes crates and rides a lift to a flag. Arrows or a gamepad, up jumps.
local WALK, JUMP, GRAVITY = 6, 9, 25 -- m/s, m/s, m/s2
local world, camera, hero, lift, coins, flag
local last_ground = -1 -- s; when it last stood
local wants_jump = -1 -- s; when the player last asked for a jump

local function add_block(x, y, width, height, more)
    local fields = more or { type = "static" }
    fields.x, fields.y, fields.width, fields.height = x, y, width, height
    return world:add_box(fields)
end

local function start()
    world = cairn.physics.new_world{ gravity_y = -GRAVITY }
    camera = cairn.camera.new{ height = 12 }
    hero = cairn.physics.new_mover{ x = 0, y = 0, height = 1.4, radius = 0.35 }
    coins = {}
    local ground = { color = { 0.30, 0.42, 0.33 } }
    for _, b in ipairs{ { 4, -1, 22, 2 }, { 19, -1, 4, 2 }, { 31, 3, 8, 10 }, { -6.5, 4, 1, 12 }, { 8, 1.9, 3, 0.4 }, { 12, 3.4, 2, 0.4 } } do
        add_block(b[1], b[2], b[3], b[4], { type = "static", data = ground })
    end
    world:add_polygon{ type = "static", points = { { 2, 0 }, { 6, 0 }, { 6, 1 } }, data = ground }
    for i = 1, 4 do add_block(17.4 + i % 2, 0.4 + (i - 1) // 2 * 0.8, 0.8, 0.8, { density = 8, data = { color = { 0.75, 0.55, 0.30 } } }) end
    lift = add_block(24, 0, 3, 0.4, { type = "kinematic", data = { color = { 0.55, 0.60, 0.75 } } })
    for _, c in ipairs{ { 8, 2.9 }, { 12, 4.4 }, { 19, 3.5 }, { 24, 10 } } do coins[#coins + 1] = { x = c[1], y = c[2] } end
    flag = { x = 33, y = 8 }
end

function cairn.load()
    cairn.input.bind("left", { "left", "a", "gamepad_left_x-" })
    cairn.input.bind("right", { "right", "d", "gamepad_left_x+" })
    cairn.input.bind("jump", { "up", "space", "w", "gamepad_a" })
    start()
end

function cairn.update(dt)
    local now = cairn.timer.time()
    local height = 4 + 4 * math.sin(now * 0.8)
    local _, lift_y = lift:position()
    lift:set_linear_velocity(0, (height - lift_y) / dt)

    local _, vy = hero:velocity()
    if hero:is_grounded() then last_ground = now end
    if cairn.input.was_pressed("jump") then wants_jump = now end
    -- A tenth of a second of grace before the ground and behind its edge.
    if now - wants_jump < 0.1 and now - last_ground < 0.1 then
        vy, wants_jump, last_ground = JUMP, -1, -1
    elseif vy > 0 and not cairn.input.is_action_down("jump") then
        vy = vy * 0.85 -- a short press is a low jump
    end
    hero:move(world, WALK * cairn.input.axis("left", "right"), vy - GRAVITY * dt, dt)
    world:step(dt)

    local x, y = hero:position()
    for i = #coins, 1, -1 do
        if (coins[i].x - x) ^ 2 + (coins[i].y - y - 0.7) ^ 2 < 1 then table.remove(coins, i) end
    end
    if y < -6 then start() end
    if x > flag.x and #coins == 0 then cairn.result{ outcome = "won" } end
    camera:set_position(x, math.max(y + 2, 3))
end

function cairn.draw(alpha)
    cairn.graphics.clear(0.62, 0.78, 0.90)
    camera:attach()
    cairn.graphics.draw_world(world)
    cairn.graphics.set_color(1, 0.85, 0.2)
    for _, coin in ipairs(coins) do cairn.graphics.circle("fill", coin.x, coin.y, 0.25) end
    cairn.graphics.set_color(0.8, 0.2, 0.2)
    cairn.graphics.rectangle("fill", flag.x, flag.y, 1.2, 0.8)
    local x, y = hero:position()
    cairn.graphics.set_color(0.15, 0.25, 0.5)
    cairn.graphics.rectangle("fill", x - 0.35, y, 0.7, 1.4, 0.35)
    camera:detach()
    cairn.graphics.set_color(0.1, 0.1, 0.1)
    cairn.graphics.print(#coins == 0 and "To the flag!" or ("%d coins to find"):format(#coins), 16, 12)
end
