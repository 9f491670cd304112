-- Draws a match: the scenery, the level in it, and what flies about.
-- Invariant: drawing changes nothing that the game depends on.

local art = require "src.art"
local damage = require "src.damage"
local lettering = require "src.lettering"
local scenery = require "src.scenery"
local slingshot = require "src.slingshot"
local things = require "src.things"

local picture = {}

local PREVIEW_INTERVAL, PREVIEW_COUNT = 0.07, 18
local LOADING_TIME = 0.35        -- s in which the next pebble hops into the pouch
local SWING_TIME = 0.8           -- s for which the empty band swings
local GOLD = { 1.0, 0.82, 0.30 }  -- the letters of big pop-ups
local fonts = {}

function picture.load()
    art.load()
    fonts.popup = cairn.graphics.new_font(22, "fonts/Dosis-ExtraBold.otf")
    fonts.big_popup = cairn.graphics.new_font(34, "fonts/Dosis-ExtraBold.otf")
end

local function set_ink(alpha)
    cairn.graphics.set_color(art.INK[1], art.INK[2], art.INK[3], alpha or 1)
end

--- Draws inside a body's frame.
local function at_body(body, dx, dy, paint)
    local graphics = cairn.graphics
    local x, y, angle = body:interpolated_transform()
    graphics.push()
    graphics.translate(x + dx, y + dy)
    graphics.rotate(angle)
    paint(body.data, body)
    graphics.pop()
end

local function draw_shade(piece)
    set_ink(0.20)
    cairn.graphics.polygon("fill", piece.outline)
end

local function draw_piece(piece)
    local graphics = cairn.graphics
    graphics.set_color(1, 1, 1)
    graphics.draw_polygon(art.image(piece.material.texture), piece.outline, piece.texture_places)
    local state = damage.state(piece.health)
    if state > 0 then
        graphics.draw_polygon(art.image(piece.material.cracks[state]), piece.outline, piece.texture_places)
    end
    graphics.set_color(1, 1, 1, 0.30)
    graphics.set_line_width(0.035)
    graphics.polygon("line", piece.bevel)
    set_ink()
    graphics.set_line_width(0.055)
    graphics.polygon("line", piece.outline)
end

local function draw_centered(image, center)
    cairn.graphics.set_color(1, 1, 1)
    cairn.graphics.draw(image, 0, 0, 0, art.SCALE, art.SCALE, center.x, center.y)
end

local function draw_grump_shade()
    set_ink(0.20)
    cairn.graphics.circle("fill", 0, 0, things.GRUMP_RADIUS)
end

--- The picture of a grump of that health: now and then it blinks, each in its own time.
local function grump_image(health, time, number)
    if health < 0.75 then
        return art.image("grump-hurt")
    end
    local blinks = (time + 1.37 * number) % 3.1 < 0.14
    return art.image(blinks and "grump-blink" or "grump")
end

local function draw_dots(x, y, radius, alpha)
    cairn.graphics.set_color(art.CREAM[1], art.CREAM[2], art.CREAM[3], alpha)
    cairn.graphics.circle("fill", x, y, radius)
end

local function draw_trail(trail)
    for i = 1, #trail, 2 do
        draw_dots(trail[i], trail[i + 1], (i // 2) % 3 == 0 and 0.075 or 0.05, 0.75)
    end
end

local function draw_preview(sling, gravity_y)
    if not sling.held or sling:pull() < slingshot.LEAST_PULL then
        return
    end
    sling:preview(gravity_y, PREVIEW_INTERVAL, PREVIEW_COUNT, function(x, y, i)
        local fade = 1 - i / (PREVIEW_COUNT + 1)
        set_ink(0.30 * fade)
        cairn.graphics.circle("fill", x, y, 0.035 + 0.075 * fade)
        draw_dots(x, y, 0.015 + 0.075 * fade, 0.25 + 0.75 * fade)
    end)
end

local function draw_band(from, x0, to_x, to_y)
    local graphics = cairn.graphics
    local x, y = x0 + from.x, from.y
    local length = math.sqrt((to_x - x) * (to_x - x) + (to_y - y) * (to_y - y))
    local width = 0.17 - 0.045 * math.min(2, length)
    set_ink()
    graphics.set_line_width(width + 0.06)
    graphics.line(x, y, to_x, to_y)
    graphics.set_color(0.55, 0.23, 0.20)
    graphics.set_line_width(width)
    graphics.line(x, y, to_x, to_y)
end

local function draw_pebble_at(x, y, angle)
    cairn.graphics.set_color(1, 1, 1)
    cairn.graphics.draw(art.image("pebble"), x, y, angle, art.SCALE, art.SCALE, art.PEBBLE.x, art.PEBBLE.y)
end

--- Where the i-th waiting pebble sits.
local function waiting_place(sling, i)
    return sling.x - 0.55 - 0.78 * i, things.PEBBLE_RADIUS
end

local function draw_waiting(match)
    local loaded = match.phase == "aiming" and 1 or 0
    for i = 1, match.shots_left - loaded do
        local x, y = waiting_place(match.slingshot, i)
        -- A little hop, one after the other.
        local beat = (match.time * 0.8 + i * 0.21) % 2.6
        local hop = beat < 0.4 and 0.16 * math.sin(beat / 0.4 * math.pi) or 0
        draw_pebble_at(x, y + hop, 0)
    end
end

--- Where the leather is. It lies behind a pebble in the pouch, seen from where that will fly (without a pull, to its
--- left), goes along with a pebble that was let go as far as the fork, and swings there for a moment.
local function leather_place(match)
    local sling = match.slingshot
    local function behind(x, y, pull_x, pull_y)
        local reach = things.PEBBLE_RADIUS / math.sqrt(pull_x * pull_x + pull_y * pull_y)
        return x + pull_x * reach, y + pull_y * reach
    end
    local x, y = sling:pouch()
    if match.phase == "aiming" then
        return behind(x, y, sling.pull_x - 0.06, sling.pull_y - 0.02)
    elseif match.phase == "flying" and match.pebble and match.phase_time < SWING_TIME then
        local px, py = match.pebble:interpolated_transform()
        if (px - x) * sling.last_x + (py - y) * sling.last_y > 0 then
            return behind(px, py, sling.last_x, sling.last_y)
        end
        local swing = 0.2 * math.exp(-6 * match.phase_time) * math.cos(42 * match.phase_time)
        return x + swing * sling.last_x, y + swing * sling.last_y
    end
    return x, y
end

--- The fork, the band, and the pebble in the pouch.
local function draw_slingshot(match)
    local graphics = cairn.graphics
    local sling = match.slingshot
    graphics.set_color(1, 1, 1)
    graphics.draw(art.image("fork-back"), sling.x, 0, 0, art.SCALE, art.SCALE, art.SLINGSHOT.x, art.SLINGSHOT.y)
    local px, py = sling:pouch()
    local is_loaded = match.phase == "aiming"
    local lx, ly = leather_place(match)
    draw_band(art.CORD_BACK, sling.x, lx, ly)
    if is_loaded then
        local x, y = px, py
        local t = math.min(1, match.phase_time / LOADING_TIME)
        if match.shots_left < match.level.shots and t < 1 then
            local wx, wy = waiting_place(sling, 1)
            x, y = wx + (px - wx) * t, wy + (py - wy) * t + 1.1 * math.sin(t * math.pi)
        end
        draw_pebble_at(x, y, 0)
    end
    draw_band(art.CORD_FRONT, sling.x, lx, ly)
    set_ink()
    graphics.circle("fill", lx, ly, 0.15)
    graphics.set_color(0.36, 0.23, 0.17)
    graphics.circle("fill", lx, ly, 0.115)
    graphics.set_color(1, 1, 1)
    graphics.draw(art.image("fork-front"), sling.x, 0, 0, art.SCALE, art.SCALE, art.SLINGSHOT.x, art.SLINGSHOT.y)
end

--- Soft shade where things stand on the ground.
local function draw_ground_shade(match)
    local image = art.image("shadow")
    cairn.graphics.set_color(1, 1, 1, 0.45)
    local function under(x, y, width)
        local nearness = 1 - y / 1.6
        if nearness > 0 then
            cairn.graphics.draw_sized(image, x, -0.07, width, 0.34)
        end
    end
    for _, body in ipairs(match.pieces) do
        local x, y = body:interpolated_transform()
        under(x, y, 0.8 + 0.5 * math.sqrt(body.data.area))
    end
    for _, body in ipairs(match.grumps) do
        local x, y = body:interpolated_transform()
        under(x, y, 1.15)
    end
    under(match.slingshot.x, 0, 1.0)
end

local function draw_bits(bits)
    local graphics = cairn.graphics
    for _, bit in ipairs(bits) do
        local t = bit.age / bit.life
        local r, g, b = table.unpack(bit.color)
        if bit.kind == "puff" then
            local size = bit.size * (0.7 + 1.1 * t)
            graphics.set_color(r, g, b, 0.75 * (1 - t))
            graphics.draw_sized(art.image("puff"), bit.x, bit.y, size * 1.6, size * 1.6)
        else
            local alpha = math.min(1, 3 * (1 - t))
            graphics.push()
            graphics.translate(bit.x, bit.y)
            graphics.rotate(bit.angle)
            graphics.set_color(r, g, b, alpha)
            graphics.polygon("fill", bit.points)
            set_ink(alpha)
            graphics.set_line_width(0.03)
            graphics.polygon("line", bit.points)
            graphics.pop()
        end
    end
end

local function draw_popups(popups, lens)
    for _, popup in ipairs(popups) do
        local alpha = math.min(1, 3 * (1 - popup.age / popup.life))
        local font = popup.is_big and fonts.big_popup or fonts.popup
        local x, y = lens:to_screen(popup.x, popup.y)
        local color = popup.is_big and GOLD or art.CREAM
        lettering.print(popup.text, x, y - font:height() / 2, "center", font, color, 2, alpha)
    end
end

function picture.draw(match, alpha)
    local lens = match.view:lens_at(alpha)
    scenery.draw_behind(lens, match.time)
    lens:attach()
    for _, body in ipairs(match.pieces) do
        at_body(body, 0.08, -0.07, draw_shade)
    end
    for _, body in ipairs(match.grumps) do
        at_body(body, 0.08, -0.07, draw_grump_shade)
    end
    draw_trail(match.trail)
    for _, body in ipairs(match.pieces) do
        at_body(body, 0, 0, draw_piece)
    end
    for i, body in ipairs(match.grumps) do
        at_body(body, 0, 0, function(grump)
            draw_centered(grump_image(grump.health, match.time, i), art.GRUMP)
        end)
    end
    draw_waiting(match)
    draw_slingshot(match)
    if match.pebble then
        at_body(match.pebble, 0, 0, function()
            draw_centered(art.image("pebble"), art.PEBBLE)
        end)
    end
    draw_preview(match.slingshot, match.GRAVITY)
    lens:detach()
    scenery.draw_ground(lens)
    lens:attach()
    draw_ground_shade(match)
    draw_bits(match.effects.bits)
    lens:detach()
    draw_popups(match.effects.popups, lens)
end

return picture
