-- The corners of things, for physics and for drawing.
-- Invariant: lists are in the body's frame; those for drawing are flat ({x1, y1, x2, y2, ...}), anticlockwise.

local outline = {}

-- Radius of the corners of what is drawn, in metres; the shapes that collide have sharp ones.
local CORNER = 0.07
local STEPS = 3

-- The textures show 3 m, so that a wooden plank has a few grains across and no piece is wider than its picture.
local TEXTURE_SIZE = 3.0

--- The corners of a piece as {x, y} pairs, anticlockwise.
function outline.corners(shape, width, height)
    local w, h = width / 2, height / 2
    if shape == "triangle" then
        return { { -w, -h }, { w, -h }, { 0, h } }
    end
    return { { -w, -h }, { w, -h }, { w, h }, { -w, h } }
end

--- The area of an anticlockwise polygon of {x, y} pairs.
function outline.area(corners)
    local twice = 0
    for i, a in ipairs(corners) do
        local b = corners[i % #corners + 1]
        twice = twice + a[1] * b[2] - b[1] * a[2]
    end
    return twice / 2
end

--- The flat outline, moved inward by `inset`, with round corners.
function outline.rounded(corners, inset)
    local flat = {}
    local count = #corners
    for i, corner in ipairs(corners) do
        local before, after = corners[(i - 2) % count + 1], corners[i % count + 1]
        local ax, ay = before[1] - corner[1], before[2] - corner[2]
        local bx, by = after[1] - corner[1], after[2] - corner[2]
        local a, b = math.sqrt(ax * ax + ay * ay), math.sqrt(bx * bx + by * by)
        ax, ay, bx, by = ax / a, ay / a, bx / b, by / b
        -- A circle that touches both sides: `reach` from the corner along each, centred on the bisector.
        local cosine = ax * bx + ay * by
        local half_tan = math.sqrt((1 - cosine) / (1 + cosine))
        local half_sin = math.sqrt((1 - cosine) / 2)
        local radius = math.max(0.005, CORNER - inset)
        local reach = math.min((radius + inset) / half_tan, 0.45 * a, 0.45 * b)
        radius = math.max(0.001, reach * half_tan - inset)
        local mx, my = ax + bx, ay + by
        local m = math.sqrt(mx * mx + my * my)
        local distance = (radius + inset) / half_sin
        local cx, cy = corner[1] + mx / m * distance, corner[2] + my / m * distance
        -- From the outward normal of the side before to that of the side after.
        local from = math.atan(ax, -ay)
        local turn = math.pi - math.acos(math.max(-1, math.min(1, cosine)))
        for step = 0, STEPS do
            local angle = from + turn * step / STEPS
            flat[#flat + 1] = cx + radius * math.cos(angle)
            flat[#flat + 1] = cy + radius * math.sin(angle)
        end
    end
    return flat
end

--- Where in its texture each point of a flat outline lies. `variant` is any integer: pieces that differ in it show
--- different parts. With `turned`, the texture's x axis follows the piece's y axis.
function outline.texture_places(flat, width, height, turned, variant)
    if turned then
        width, height = height, width
    end
    local function shifted(fraction, side)
        local room = 1 - side / TEXTURE_SIZE
        return 0.5 + room * (fraction % 1 - 0.5)
    end
    local u0, v0 = shifted(variant * 0.618034, width), shifted(variant * 0.754878 + 0.31, height)
    local places = {}
    for i = 1, #flat, 2 do
        local x, y = flat[i], flat[i + 1]
        if turned then
            x, y = y, -x
        end
        places[i] = u0 + x / TEXTURE_SIZE
        places[i + 1] = v0 - y / TEXTURE_SIZE
    end
    return places
end

return outline
