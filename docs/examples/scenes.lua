-- Three scenes: a title whose letters fall in, a game that a camera follows, and a pause over it.
-- Space starts, arrows roll the ball, P pauses, Escape leaves; the mouse wheel zooms.
local g = cairn.graphics
local title, game, pause = {}, {}, { overlay = true }
local big

function cairn.load()
    big = g.new_font(64)
    cairn.scene.push(title)
end

-- ---- Title

function title:enter()
    self.letters = {}
    local word = "CAIRN"
    for i = 1, #word do
        local letter = { text = word:sub(i, i), y = -80, alpha = 0 }
        self.letters[i] = letter
        cairn.tween.to(letter, { y = 300, alpha = 1 }, 0.9, { ease = "bounce_out", delay = 0.12 * i })
    end
    self.hint = { alpha = 0 }
    cairn.tween.to(self.hint, { alpha = 1 }, 0.6, { ease = "sine_in_out", delay = 1.5, repeats = -1, yoyo = true })
end

function title:leave() cairn.tween.cancel_all(self.hint) end

function title:draw()
    g.clear(0.09, 0.11, 0.16)
    g.set_font(big)
    for i, letter in ipairs(self.letters) do
        g.set_color(0.95, 0.75, 0.45, letter.alpha)
        g.print(letter.text, 640 + (i - 3) * 62, letter.y, "center")
    end
    g.set_color(1, 1, 1, self.hint.alpha)
    g.set_font(g.new_font(20))
    g.print("press space", 640, 420, "center")
end

function title:key_pressed(key)
    if key == "space" then cairn.scene.switch(game) end
end

-- ---- Game

function game:enter()
    self.world = cairn.physics.new_world{}
    self.camera = cairn.camera.new{ height = 12, follow_rate = 4, dead_zone_width = 2 }
    self.camera:set_bounds(-40, -4, 40, 14)
    local ground = self.world:new_body{ type = "static" }
    for x = -40, 39 do
        local rise = cairn.random.integer(0, 2)
        ground:add_box{ x = x + 0.5, y = -2 + rise / 4, width = 1, height = 4 }
    end
    ground:add_box{ x = -40.5, y = 5, width = 1, height = 20 }
    ground:add_box{ x = 40.5, y = 5, width = 1, height = 20 }
    for i = 1, 30 do
        local size = cairn.random.number(0.4, 1)
        self.world:add_box{ x = cairn.random.normal(0, 16), y = 3 + i % 4, width = size, height = size,
            data = { color = cairn.random.visual:choose{ { 0.8, 0.4, 0.3 }, { 0.9, 0.7, 0.4 }, { 0.4, 0.6, 0.7 } } } }
    end
    self.ball = self.world:add_circle{ y = 4, radius = 0.5, density = 4, angular_damping = 1, data = { color = { 0.95, 0.95, 0.9 } } }
end

function game:leave() self.world:destroy() end

function game:update(dt)
    local turn = (cairn.input.is_down("left") and 1 or 0) - (cairn.input.is_down("right") and 1 or 0)
    self.ball:apply_torque(4 * turn)
    self.world:step(dt)
    for _, _, _, impulse in self.world:events("hit") do
        if impulse > 6 then self.camera:shake(impulse / 60) end
    end
    self.camera:follow(self.ball:position())
    self.camera:update(dt)
end

function game:draw()
    g.clear(0.62, 0.76, 0.84)
    self.camera:attach()
    g.draw_world(self.world)
    self.camera:detach()
    g.set_color(0.1, 0.1, 0.15)
    g.print(("zoom %.2f"):format(self.camera:zoom()), 12, 8)
end

function game:key_pressed(key)
    if key == "p" then cairn.scene.push(pause) end
    if key == "escape" then cairn.scene.switch(title) end
end

function game:wheel(_, dy)
    local x, y = cairn.input.mouse_position()
    self.camera:zoom_at(x, y, dy > 0 and 1.25 or 0.8)
end

-- ---- Pause: drawn over the game, which stands still meanwhile

function pause:enter()
    self.shade = 0
    cairn.tween.to(self, { shade = 0.6 }, 0.25)
end

function pause:draw()
    g.set_color(0.05, 0.06, 0.1, self.shade)
    g.rectangle("fill", 0, 0, 1280, 720)
    g.set_color(1, 1, 1)
    g.set_font(big)
    g.print("Paused", 640, 300, "center")
end

function pause:key_pressed(key)
    if key == "p" or key == "escape" then cairn.scene.pop() end
end
