-- A camp fire, rain and fireworks, all of particles. Click for a firework.
local g = cairn.graphics
local fire, smoke, rain, rockets = nil, nil, nil, {}

function cairn.load()
    fire = cairn.particles.new{
        rate = 140, x = 640, y = 600, area_width = 50, lifetime = 0.5, lifetime_max = 1.1,
        speed = 60, speed_max = 150, direction = -math.pi / 2, spread = 0.7, acceleration_y = -120,
        size = 50, size_max = 80, size_end = 6, blend = "add",
        colors = { { 1, 0.75, 0.25, 0 }, { 1, 0.55, 0.15, 0.5 }, { 0.8, 0.15, 0.05, 0.25 }, { 0.2, 0.05, 0.1, 0 } },
    }
    smoke = cairn.particles.new{
        rate = 14, x = 640, y = 500, lifetime = 3, lifetime_max = 5, speed = 30, speed_max = 60,
        direction = -1.4, spread = 0.4, size = 40, size_end = 220, spin = -0.5, spin_max = 0.5,
        colors = { { 0.5, 0.5, 0.55, 0 }, { 0.4, 0.4, 0.45, 0.25 }, { 0.3, 0.3, 0.35, 0 } },
    }
    rain = cairn.particles.new{
        rate = 300, x = 640, y = -20, area_width = 1500, lifetime = 1.3, speed = 560, speed_max = 640,
        direction = math.pi / 2 + 0.1, spread = 0, size = 5, colors = { { 0.6, 0.7, 0.9, 0.5 } }, max_count = 600,
    }
    for _, emitter in ipairs{ fire, smoke, rain } do emitter:start() end
    cairn.timer.every(1.2, function()
        cairn.mouse_pressed(cairn.random.visual:number(150, 1130), cairn.random.visual:number(90, 300))
    end)
end

function cairn.mouse_pressed(x, y)
    local hue = cairn.random.visual:choose{ { 1, 0.5, 0.3 }, { 0.4, 0.8, 1 }, { 0.6, 1, 0.5 }, { 1, 0.6, 0.9 } }
    local rocket = cairn.particles.new{
        lifetime = 0.8, lifetime_max = 1.7, speed = 40, speed_max = 300, damping = 1.6, acceleration_y = 110,
        size = 9, size_max = 14, size_end = 2, blend = "add",
        colors = { { 1, 1, 1 }, hue, { hue[1], hue[2], hue[3], 0 } },
    }
    rocket:emit(220, x, y)
    rockets[#rockets + 1] = rocket
end

function cairn.update(dt)
    for _, emitter in ipairs{ fire, smoke, rain } do emitter:update(dt) end
    for i = #rockets, 1, -1 do
        rockets[i]:update(dt)
        if not rockets[i]:is_active() then table.remove(rockets, i) end
    end
end

function cairn.draw()
    g.mesh{ 0, 0, 0.03, 0.04, 0.09, 1, 1280, 0, 0.03, 0.04, 0.09, 1, 1280, 720, 0.10, 0.09, 0.14, 1,
            0, 0, 0.03, 0.04, 0.09, 1, 1280, 720, 0.10, 0.09, 0.14, 1, 0, 720, 0.10, 0.09, 0.14, 1 }
    g.set_color(0.07, 0.06, 0.08)
    g.rectangle("fill", 0, 610, 1280, 110)
    g.set_color(0.25, 0.15, 0.1)
    g.capsule("fill", 590, 625, 690, 600, 10)
    g.capsule("fill", 590, 600, 690, 625, 10)
    g.set_color(1, 1, 1)
    for _, rocket in ipairs(rockets) do rocket:draw() end
    smoke:draw()
    fire:draw()
    rain:draw()
    local count = fire:count() + smoke:count() + rain:count()
    for _, rocket in ipairs(rockets) do count = count + rocket:count() end
    g.print(("%d particles"):format(count), 12, 8)
end
