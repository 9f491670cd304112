-- What cairn.graphics draws: shapes, blend modes, a canvas, quads and a batch, a nine-patch, text in a box.
local g = cairn.graphics
local canvas, frame, batch, title

-- Everything is drawn by the script itself, so that it needs no files.
local function paint_canvas()
    canvas:attach(0, 0, 0, 0)
    g.set_color(0.95, 0.45, 0.30)
    g.circle("fill", 24, 24, 20)
    g.set_color(0.99, 0.85, 0.55)
    g.arc("fill", 24, 24, 20, -0.6, 0.6)
    canvas:detach()

    frame:attach(0, 0, 0, 0)
    g.set_color(0.16, 0.24, 0.33)
    g.rectangle("fill", 0, 0, 48, 48, 14)
    g.set_color(0.55, 0.75, 0.85)
    g.set_line_width(3)
    g.rectangle("line", 3, 3, 42, 42, 11)
    frame:detach()
    g.set_line_width(1)
    g.set_color(1, 1, 1)
end

function cairn.load()
    canvas = g.new_canvas(48, 48)
    frame = g.new_canvas(48, 48)
    title = g.new_font(34)
    batch = g.new_batch(canvas)
    local upper = g.new_quad(canvas, 0, 0, 48, 24)
    for i = 0, 199 do
        local turn = i / 200 * 2 * math.pi
        batch:set_color(1, 1, 1, 0.4 + 0.6 * i / 200)
        batch:add(980 + 190 * math.cos(turn), 230 + 150 * math.sin(turn), turn, 0.6, 0.6, 24, 24, i % 2 == 0 and upper or nil)
    end
end

local function label(text, x, y) g.print(text, x, y) end

function cairn.draw()
    g.clear(0.10, 0.13, 0.17)
    paint_canvas()
    g.set_font(title)
    g.print("Pictures", 640, 24, "center")
    g.set_font(g.new_font(18))

    label("shapes", 60, 90)
    g.set_color(0.45, 0.75, 0.50)
    g.ellipse("fill", 140, 180, 80, 40)
    g.set_color(0.90, 0.75, 0.35)
    g.arc("fill", 330, 180, 60, 0.5, 5.8)
    g.set_line_width(8)
    g.arc("line", 470, 180, 52, 2.4, 6.9)
    g.set_line_width(1)
    g.set_color(1, 1, 1)

    label("blend modes over a gradient", 60, 270)
    for i, mode in ipairs{ "alpha", "add", "multiply", "screen" } do
        local x = 60 + (i - 1) * 130
        g.mesh{ x, 300, 0.1, 0.1, 0.4, 1, x + 110, 300, 0.1, 0.1, 0.4, 1, x + 110, 400, 0.9, 0.8, 0.5, 1,
                x, 300, 0.1, 0.1, 0.4, 1, x + 110, 400, 0.9, 0.8, 0.5, 1, x, 400, 0.9, 0.8, 0.5, 1 }
        g.set_blend_mode(mode)
        g.set_color(0.8, 0.4, 0.3, 0.8)
        g.circle("fill", x + 55, 350, 36)
        g.set_blend_mode("alpha")
        g.set_color(1, 1, 1)
        g.print(mode, x + 55, 404, "center")
    end

    label("a batch of 200 sprites, one draw call", 830, 420)
    batch:draw()

    label("one nine-patch, three sizes", 60, 450)
    g.draw_nine_patch(frame, 60, 490, 90, 60, 16)
    g.draw_nine_patch(frame, 170, 490, 420, 180, 16)
    g.draw_nine_patch(frame, 60, 570, 90, 100, 16)
    g.print("Text is broken at the width of its box, and set at the left, in the middle or at the right of it.",
            190, 510, "center", 380)
    g.print("Right.", 190, 630, "right", 380)

    label("canvas, sheared and clipped", 830, 490)
    g.set_scissor(830, 520, 300, 120)
    g.push()
    g.translate(840, 510)
    g.shear(0.5, 0)
    g.scale(3)
    for i = 0, 2 do g.draw(canvas, 34 * i, 0) end
    g.pop()
    g.set_scissor()
end
