-- A conversation: colored words in wrapped lines, typed before the player's eyes. Space goes on.
local g = cairn.graphics
local gold, sea = { 1, 0.8, 0.4 }, { 0.5, 0.85, 0.95 }
local pages = {
    { "Stones remember. Put one on another, and another on those, and you have a ", { "cairn", table.unpack(gold) },
        ": a sign that says somebody was here." },
    { "Walkers add a stone each. Nobody has ever seen one taken away, says the ", { "keeper", table.unpack(sea) },
        ", but in the morning the oldest lie at the bottom again." },
    { "Shall we build?" },
}
local page, text, shown = 0, nil, 0

local function turn()
    page = page % #pages + 1
    text = cairn.text.new(pages[page], { width = 620, line_spacing = 1.3 }, g.new_font(26))
    shown = 0
end

function cairn.load() turn() end

function cairn.update()
    shown = math.min(shown + 0.6, text:length())
    text:set_shown(math.floor(shown))
end

function cairn.key_pressed(key)
    if key ~= "space" then return end
    if shown < text:length() then shown = text:length() else turn() end
end

function cairn.draw()
    g.clear(0.09, 0.11, 0.15)
    g.set_color(0.15, 0.19, 0.26)
    g.rectangle("fill", 290, 400, 700, 240, 18)
    g.set_color(1, 1, 1)
    text:draw(330, 430)
    if shown == text:length() then
        g.set_color(1, 1, 1, 0.5 + 0.5 * math.sin(cairn.timer.time() * 4))
        g.print("space", 950, 604, "right")
    end
    -- The cairn grows with every page.
    for i = 0, 2 + page do
        g.set_color(0.42 + 0.05 * (i % 3), 0.44, 0.48)
        g.ellipse("fill", 640 + 14 * math.sin(i * 2.1), 340 - 34 * i, 84 - 11 * i, 22)
    end
end
