-- A thousand bodies that a script stirs in each update: how fast Cairn draws and scripts.
--   cairn play docs/examples/thousand.lua --timings              prints the slowest frame at the end
--   cairn play docs/examples/thousand.lua --timings -- 5000      with another number of bodies
local world, camera
local bodies = {}
local SIDE = 40 -- metres

local function add_walls()
    for _, wall in ipairs{ { 0, -1 }, { 0, SIDE + 1 }, { -SIDE, SIDE / 2 }, { SIDE, SIDE / 2 } } do
        local lies = wall[1] == 0
        world:add_box{
            type = "static", x = wall[1], y = wall[2],
            width = lies and 2 * SIDE or 2, height = lies and 2 or SIDE + 4,
        }
    end
end

function cairn.load(args)
    local count = math.tointeger(tonumber(args[1] or 1000)) or 1000
    world = cairn.physics.new_world{ gravity_y = 0 }
    camera = cairn.camera.new{ y = SIDE / 2, height = SIDE + 4 }
    add_walls()
    local columns = math.ceil(math.sqrt(2 * count))
    local gap = 2 * (SIDE - 3) / columns
    for i = 0, count - 1 do
        local x = -SIDE + 3 + gap * (i % columns + 0.5)
        local y = 1.5 + gap * (i // columns + 0.5)
        local data = { color = { 0.4 + 0.5 * (i % 7) / 6, 0.55, 0.9 - 0.5 * (i % 5) / 4 } }
        if i % 2 == 0 then
            bodies[#bodies + 1] = world:add_box{ x = x, y = y, width = 0.6 * gap, height = 0.6 * gap, data = data }
        else
            bodies[#bodies + 1] = world:add_circle{ x = x, y = y, radius = 0.32 * gap, data = data }
        end
    end
end

function cairn.update(dt)
    for _, body in ipairs(bodies) do
        local x, y = body:position()
        local mass = body:mass()
        body:apply_force_to_center(-2 * (y - SIDE / 2) * mass, 2 * x * mass)
    end
    world:step(dt)
end

function cairn.draw()
    cairn.graphics.clear(0.09, 0.10, 0.13)
    camera:attach()
    cairn.graphics.draw_world(world)
    camera:detach()
end
