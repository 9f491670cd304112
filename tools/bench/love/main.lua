-- What body:getPosition() costs in LÖVE: the same loops as scripting/bridge/lua_cost.cpp has, and the same count of
-- bodies, calls and repeats. Prints nanoseconds for each call. Run by `cairn-bench lua` where `love` is installed.
local BODIES, ROUNDS, REPEATS = 1000, 20, 400

local bodies = {}
local world = love.physics.newWorld(0, 0, true)
for i = 1, BODIES do
    bodies[i] = love.physics.newBody(world, i % 40, math.floor(i / 40), "dynamic")
end

local function loop()
    local sum = 0
    for _ = 1, ROUNDS do
        for i = 1, #bodies do local body = bodies[i] local x, y = i, i sum = sum + x + y end
    end
    return sum
end

local function position()
    local sum = 0
    for _ = 1, ROUNDS do
        for i = 1, #bodies do local body = bodies[i] local x, y = body:getPosition() sum = sum + x + y end
    end
    return sum
end

local function best(action)
    local shortest = math.huge
    for _ = 1, REPEATS do
        local begin = love.timer.getTime()
        action()
        shortest = math.min(shortest, love.timer.getTime() - begin)
    end
    return shortest
end

function love.load()
    print(("%.2f"):format((best(position) - best(loop)) / (BODIES * ROUNDS) * 1e9))
    love.event.quit()
end
