-- What flies about when things are hit: chips, puffs of dust, points that float up.
-- Invariant: nothing here touches the world; all chance is from the visual stream, so effects cannot change a replay.

local effects = {}
effects.__index = effects

local MOST = 260                -- bits at a time; the oldest go first
local GRAVITY = -9
local DUST = { 0.93, 0.88, 0.78 }

function effects.new()
    return setmetatable({ bits = {}, popups = {} }, effects)
end

local function chance(low, high)
    return cairn.random.visual:number(low, high)
end

local function add(list, bit)
    if #list >= MOST then
        table.remove(list, 1)
    end
    bit.age = 0
    list[#list + 1] = bit
end

--- Chips of a color, flying from (x, y) on from a velocity.
function effects:chips(x, y, vx, vy, count, spread, color)
    for _ = 1, count do
        local side = chance(0.05, 0.15)
        add(self.bits, {
            kind = "chip", color = color, life = chance(0.5, 1.1),
            x = x + chance(-spread, spread), y = y + chance(-spread, spread),
            vx = 0.6 * vx + chance(-2.6, 2.6), vy = 0.6 * vy + chance(-1.0, 3.8),
            angle = chance(0, 6.28), spin = chance(-9, 9),
            points = { -side, -side * 0.5, side * 0.8, -side * 0.7, side * 0.5, side * 0.8, -side * 0.6, side * 0.5 },
        })
    end
end

--- Puffs of dust or of another color, growing and fading.
function effects:puffs(x, y, count, size, color)
    for _ = 1, count do
        add(self.bits, {
            kind = "puff", color = color or DUST, life = chance(0.35, 0.75),
            x = x + chance(-size, size) * 0.4, y = y + chance(-size, size) * 0.3,
            vx = chance(-1.2, 1.2) * size, vy = chance(0.1, 1.0) * size,
            size = size * chance(0.6, 1.1),
        })
    end
end

--- Points that float up from (x, y).
function effects:popup(text, x, y, is_big)
    add(self.popups, { text = text, x = x, y = y, life = is_big and 1.5 or 1.0, is_big = is_big })
end

local function aged(list, dt, move)
    local kept = {}
    for _, bit in ipairs(list) do
        bit.age = bit.age + dt
        if bit.age < bit.life then
            move(bit)
            kept[#kept + 1] = bit
        end
    end
    return kept
end

function effects:update(dt)
    local slowing = math.exp(-3 * dt)
    self.bits = aged(self.bits, dt, function(bit)
        bit.x, bit.y = bit.x + bit.vx * dt, bit.y + bit.vy * dt
        if bit.kind == "puff" then
            bit.vx, bit.vy = bit.vx * slowing, bit.vy * slowing
            return
        end
        bit.vy = bit.vy + GRAVITY * dt
        bit.angle = bit.angle + bit.spin * dt
        if bit.y < 0.05 and bit.vy < 0 then
            bit.y, bit.vx, bit.vy, bit.spin = 0.05, bit.vx * 0.5, -0.3 * bit.vy, 0.5 * bit.spin
        end
    end)
    self.popups = aged(self.popups, dt, function(popup)
        popup.y = popup.y + 1.1 * dt * (1 - popup.age / popup.life)
    end)
end

return effects
