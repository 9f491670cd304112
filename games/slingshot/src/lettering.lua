-- Light letters with a dark rim, for text over the picture.
-- Invariant: letters and rim fade together, and the letters stay the lighter of the two until both are gone.

local art = require "src.art"

local lettering = {}

local COPIES = 8                -- of the text in ink, around the place of the letters
local RIM = 0.8                 -- opacity of one copy: where few of them meet, at its outside, the rim is soft

--- The opacity of one copy for which all of them on top of each other, as they lie behind the letters, cover as much as
--- the square of `alpha`. The same share of RIM would not fade at all before the letters are gone: eight copies of 0.2
--- cover 0.83. With the square instead of `alpha` itself the rim goes a little ahead and does not darken the letters.
local function rim_alpha(alpha)
    return math.min(RIM, 1 - (1 - alpha * alpha) ^ (1 / COPIES))
end

--- Prints text at a place in pixels, in a {r, g, b} color, with a rim of `width` pixels.
function lettering.print(text, x, y, align, font, color, width, alpha)
    local graphics = cairn.graphics
    graphics.set_font(font)
    graphics.set_color(art.INK[1], art.INK[2], art.INK[3], rim_alpha(alpha))
    for k = 0, COPIES - 1 do
        local angle = k * 2 * math.pi / COPIES
        graphics.print(text, x + width * math.cos(angle), y + width * math.sin(angle), align)
    end
    graphics.set_color(color[1], color[2], color[3], alpha)
    graphics.print(text, x, y, align)
end

return lettering
