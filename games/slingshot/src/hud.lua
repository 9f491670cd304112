-- What lies over the picture: points, buttons, hints, and the panel at the end. All in pixels of 1280 x 720.
-- Invariant: a button does what it shows, wherever it is drawn: one table has both its place and its action.

local art = require "src.art"
local lettering = require "src.lettering"

local hud = {}

local FONT = "fonts/Dosis-ExtraBold.otf"
local WIDTH, HEIGHT = 1280, 720
local PANEL = { x = 390, y = 140, width = 500, height = 424 }
local BUTTON_SIZE = 64

-- Every button: its picture, its middle, the function of the game it calls, and when it is there.
local BUTTONS = {
    { image = "button-restart", x = WIDTH - 48, y = 48, action = "restart",
      is_shown = function(match) return not match:is_over() end },
    { image = "button-pause", x = WIDTH - 122, y = 48, action = "toggle_pause",
      is_shown = function(match) return not match:is_over() end },
    { image = "button-restart", x = WIDTH / 2, y = PANEL.y + 344, action = "restart",
      is_shown = function(match) return match:is_over() end },
}

local fonts = {}

function hud.load()
    local new_font = cairn.graphics.new_font
    fonts.small, fonts.middle, fonts.large, fonts.huge =
        new_font(22, FONT), new_font(30, FONT), new_font(46, FONT), new_font(60, FONT)
end

--- The action of the button under a place, if there is one.
function hud.action_at(match, x, y)
    for _, button in ipairs(BUTTONS) do
        local dx, dy = x - button.x, y - button.y
        if button.is_shown(match) and dx * dx + dy * dy <= BUTTON_SIZE * BUTTON_SIZE / 4 then
            return button.action
        end
    end
end

local function set_color(color, alpha)
    cairn.graphics.set_color(color[1], color[2], color[3], alpha or 1)
end

local function print_rimmed(text, x, y, align, font, alpha)
    lettering.print(text, x, y, align, font, art.CREAM, 2.2, alpha or 1)
end

local function print_ink(text, x, y, align, font, alpha)
    cairn.graphics.set_font(font)
    set_color(art.INK, alpha)
    cairn.graphics.print(text, x, y, align)
end

--- 12340 as "12 340".
local function grouped(points)
    local text = tostring(points)
    return (text:reverse():gsub("(%d%d%d)(%d)", "%1 %2"):reverse())
end

local function draw_buttons(match)
    cairn.graphics.set_color(1, 1, 1)
    for _, button in ipairs(BUTTONS) do
        if button.is_shown(match) then
            cairn.graphics.draw_sized(art.image(button.image), button.x, button.y, BUTTON_SIZE, BUTTON_SIZE)
        end
    end
end

local function draw_points(match)
    print_rimmed("SCORE", 28, 16, "left", fonts.small)
    print_rimmed(grouped(match.points), 28, 38, "left", fonts.large)
end

--- The level's name at first; how to play until the first shot.
local function draw_hints(match)
    if match.shots_left < match.level.shots then
        return
    end
    local alpha = math.max(0, math.min(1, match.time / 0.4, 3.6 - match.time))
    print_rimmed(match.level.name, WIDTH / 2, 78, "center", fonts.huge, alpha)
    if not match.slingshot.held and match.level.hint ~= "" then
        local appeared = math.min(1, match.time / 0.4)
        print_rimmed(match.level.hint, WIDTH / 2, HEIGHT - 96, "center", fonts.middle, appeared)
        print_rimmed("mouse, or arrow keys and space", WIDTH / 2, HEIGHT - 58, "center", fonts.small, appeared)
    end
end

local function draw_sheet(rise)
    local graphics = cairn.graphics
    local x, y, w, h = PANEL.x, PANEL.y + rise, PANEL.width, PANEL.height
    set_color(art.INK, 0.25)
    graphics.rectangle("fill", x - 2, y + 8, w + 4, h + 2, 34)
    set_color(art.INK)
    graphics.rectangle("fill", x - 5, y - 5, w + 10, h + 10, 36)
    graphics.set_color(0.93, 0.84, 0.70)
    graphics.rectangle("fill", x, y, w, h, 31)
    set_color(art.CREAM)
    graphics.rectangle("fill", x, y, w, h - 8, 31)
end

--- 0..1 with a little overshoot on the way.
local function spring(t)
    if t <= 0 then
        return 0
    elseif t >= 1 then
        return 1
    end
    local back = t - 1
    return 1 + 2.7 * back * back * back + 1.7 * back * back
end

local function draw_stars(match, rise)
    for i = 1, 3 do
        local x = WIDTH / 2 + (i - 2) * 128
        local y = PANEL.y + rise + 154 - (i == 2 and 8 or 0)
        local size = i == 2 and 120 or 104
        cairn.graphics.set_color(1, 1, 1)
        cairn.graphics.draw_sized(art.image("star-empty"), x, y, size, size)
        if i <= match.stars then
            local grown = spring((match.phase_time - match.STAR_TIMES[i]) / 0.3)
            if grown > 0 then
                cairn.graphics.draw_sized(art.image("star-full"), x, y, size * grown, size * grown)
            end
        end
    end
end

local function draw_end(match)
    local t = math.min(1, match.phase_time / 0.45)
    local rise = 60 * (1 - spring(t))
    set_color(art.INK, 0.45 * t)
    cairn.graphics.rectangle("fill", 0, 0, WIDTH, HEIGHT)
    draw_sheet(rise)
    local won = match.phase == "won"
    print_ink(won and "Hill cleared!" or "Not this time", WIDTH / 2, PANEL.y + rise + 18, "center", fonts.large)
    draw_stars(match, rise)
    print_ink(grouped(match.points), WIDTH / 2, PANEL.y + rise + 208, "center", fonts.huge)
    local line
    if won and match.bonus > 0 then
        line = ("with %s for %d spare %s"):format(grouped(match.bonus), match.shots_left,
            match.shots_left == 1 and "pebble" or "pebbles")
    elseif won then
        line = "with the very last pebble"
    else
        local count = match.grumps_left
        line = count == 1 and "one grump is still grumpy" or ("%d grumps are still grumpy"):format(count)
    end
    print_ink(line, WIDTH / 2, PANEL.y + rise + 274, "center", fonts.small, 0.75)
    print_ink("play again (R)", WIDTH / 2, PANEL.y + rise + 378, "center", fonts.small, 0.55)
end

local function draw_pause()
    set_color(art.INK, 0.55)
    cairn.graphics.rectangle("fill", 0, 0, WIDTH, HEIGHT)
    print_rimmed("Paused", WIDTH / 2, 120, "center", fonts.huge)
    print_rimmed("P goes on, R starts again", WIDTH / 2, 200, "center", fonts.middle)
end

function hud.draw(match, is_paused)
    draw_points(match)
    if match:is_over() then
        draw_end(match)
    else
        if is_paused then
            draw_pause()
        else
            draw_hints(match)
        end
    end
    draw_buttons(match)
end

return hud
