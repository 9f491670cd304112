-- Sky, clouds, hills and ground behind and under the level.
-- Invariant: what is farther moves less; tiles meet at whole pixels, so that no seam shows.

local art = require "src.art"

local scenery = {}

-- name of the picture, share of the camera's movement, height of its lower edge above the ground line in pixels at the
-- level's own zoom
local HILLS = {
    { "hills-far", 0.06, 40 },
    { "hills-middle", 0.14, -8 },
    { "hills-near", 0.28, -60 },
}

-- name, x and y in the picture, size, pixels per second
local CLOUDS = {
    { "cloud-1", 120, 84, 0.95, 5 },
    { "cloud-2", 560, 150, 0.70, 3 },
    { "cloud-1", 880, 52, 0.62, 4 },
    { "cloud-2", 1240, 108, 0.85, 4.5 },
}
local CLOUD_ROUND = 1600         -- after so many pixels a cloud comes in again from the left

-- Things on the ground: name, x in metres, size, is it in front of the level
local GROWTH = {
    { "tuft", -3.1, 1.0, true }, { "tuft", 1.5, 0.8, true }, { "tuft", 5.2, 1.1, true }, { "tuft", 7.9, 0.7, true },
    { "tuft", 17.3, 1.0, true }, { "tuft", 18.6, 0.8, true },
    { "cairn", 6.3, 0.62, false }, { "tuft", 5.75, 0.75, false },
}

local function draw_tiled(image, left, bottom, width, height)
    local screen_width = cairn.graphics.size()
    local x = left % width - width
    while x < screen_width do
        local x0, x1 = math.floor(x), math.floor(x + width)
        cairn.graphics.draw_sized(image, (x0 + x1) / 2, bottom - height / 2, x1 - x0, height)
        x = x + width
    end
end

--- Pixels per metre of a camera, and where the ground line and x = 0 are on the screen.
local function frame_of(lens)
    local x0, ground_y = lens:to_screen(0, 0)
    local x1 = lens:to_screen(1, 0)
    return x1 - x0, x0, math.floor(ground_y + 0.5)
end

function scenery.draw_behind(lens, time)
    local graphics = cairn.graphics
    local width, height = graphics.size()
    graphics.set_color(1, 1, 1)
    graphics.draw_sized(art.image("sky"), width / 2, height / 2, width, height)
    for _, cloud in ipairs(CLOUDS) do
        local name, x, y, size, speed = table.unpack(cloud)
        graphics.draw(art.image(name), (x + speed * time) % CLOUD_ROUND - 280, y, 0, size, size)
    end
    local pixels, x0, ground_y = frame_of(lens)
    for _, hills in ipairs(HILLS) do
        local name, share, above = table.unpack(hills)
        local image = art.image(name)
        -- Half as much zoom as the level: distant things grow less.
        local zoom = 0.5 + 0.5 * pixels / 68
        local w, h = image:size()
        draw_tiled(image, x0 * share, ground_y - above * zoom, w * zoom, h * zoom)
    end
    for _, thing in ipairs(GROWTH) do
        local name, x, size, in_front = table.unpack(thing)
        if not in_front then
            local image = art.image(name)
            local w, h = image:size()
            local scale = size * pixels * art.SCALE
            graphics.draw(image, x0 + x * pixels, ground_y + 4, 0, scale, scale, w / 2, h)
        end
    end
end

function scenery.draw_ground(lens)
    local graphics = cairn.graphics
    local width, height = graphics.size()
    local pixels, x0, ground_y = frame_of(lens)
    local image = art.image("ground")
    local w, h = image:size()
    local scale = pixels * art.SCALE
    local bottom = ground_y + (h - art.GROUND_LINE) * scale
    graphics.set_color(0.427, 0.278, 0.22)
    if bottom < height then
        graphics.rectangle("fill", 0, math.floor(bottom) - 1, width, height - bottom + 2)
    end
    graphics.set_color(1, 1, 1)
    draw_tiled(image, x0, bottom, w * scale, h * scale)
    for _, thing in ipairs(GROWTH) do
        local name, x, size, in_front = table.unpack(thing)
        if in_front then
            local growth = art.image(name)
            local gw, gh = growth:size()
            local s = size * scale
            graphics.draw(growth, x0 + x * pixels, ground_y + 10, 0, s, s, gw / 2, gh)
        end
    end
end

return scenery
