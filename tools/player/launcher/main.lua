-- What `cairn` shows when it is started without a command: the bundled games with their pictures, to be chosen
-- by keys, mouse, finger or gamepad. It is a game like any other; the program plays what its result names.
local shelf = require("shelf")

local self, large, small
local pressed -- the card under the mouse or the finger when it went down

local function load_picture(game)
    for _, name in ipairs{ "picture.png", "images/icon.png", "icon.png" } do
        local path = game.folder .. "/" .. name
        if cairn.files.exists(path) then
            local ok, image = pcall(cairn.graphics.new_image, path)
            if ok then
                game.picture = image
                return
            end
        end
    end
end

function cairn.load()
    self = shelf.new()
    large, small = cairn.graphics.new_font(40), cairn.graphics.new_font(20)
    for _, game in ipairs(self.games) do
        load_picture(game)
    end
    cairn.input.bind("left", { "left", "a", "gamepad_dpad_left", "gamepad_left_x-" })
    cairn.input.bind("right", { "right", "d", "gamepad_dpad_right", "gamepad_left_x+" })
    cairn.input.bind("up", { "up", "w", "gamepad_dpad_up", "gamepad_left_y-" })
    cairn.input.bind("down", { "down", "s", "gamepad_dpad_down", "gamepad_left_y+" })
    cairn.input.bind("play", { "return", "space", "keypad_enter", "gamepad_a", "gamepad_start" })
    cairn.input.bind("quit", { "escape", "gamepad_b", "gamepad_back" })
end

local function play(index)
    local game = self.games[index]
    if game then
        cairn.result{ outcome = "play", level = game.folder }
        cairn.quit()
    end
end

function cairn.action_pressed(action)
    if action == "play" then
        play(self.chosen)
    elseif action == "quit" then
        cairn.quit()
    else
        shelf.move(self, action == "left" and -1 or action == "right" and 1 or 0,
            action == "up" and -1 or action == "down" and 1 or 0)
    end
end

function cairn.mouse_moved(x, y)
    self.chosen = shelf.at(self, x, y) or self.chosen
end

function cairn.mouse_pressed(x, y)
    pressed = shelf.at(self, x, y)
    self.chosen = pressed or self.chosen
end

function cairn.mouse_released(x, y)
    if pressed and shelf.at(self, x, y) == pressed then
        play(pressed)
    end
    pressed = nil
end

function cairn.wheel(_, dy)
    shelf.move(self, 0, dy > 0 and -1 or 1)
end

function cairn.update()
    local _, height = cairn.graphics.size()
    shelf.update(self, height)
end

local function draw_card(index, game)
    local g = cairn.graphics
    local x, y, width, height = shelf.card(self, index)
    local is_chosen = index == self.chosen
    if is_chosen then
        g.set_color(0.95, 0.76, 0.46)
        g.rectangle("fill", x - 5, y - 5, width + 10, height + 10, 14)
    end
    g.set_color(0.17, 0.20, 0.24)
    g.rectangle("fill", x, y, width, height, 10)
    local picture_height = height - 52
    if game.picture then
        local w, h = game.picture:size()
        local scale = math.min(width / w, picture_height / h)
        g.set_color(1, 1, 1)
        g.draw_sized(game.picture, x + width / 2, y + picture_height / 2, scale * w, scale * h)
    else
        g.set_color(0.30, 0.36, 0.43)
        g.set_font(large)
        g.print(game.title:sub(1, 1), x + width / 2, y + picture_height / 2 - 24, "center")
    end
    g.set_font(small)
    g.set_color(is_chosen and 1 or 0.75, is_chosen and 1 or 0.78, is_chosen and 1 or 0.81)
    g.print(game.title, x + width / 2, y + height - 38, "center")
end

function cairn.draw()
    local g = cairn.graphics
    local width, height = g.size()
    g.set_scissor(0, 116, width, height - 116 - 52)
    for index, game in ipairs(self.games) do
        draw_card(index, game)
    end
    g.set_scissor()
    g.set_font(large)
    g.set_color(0.92, 0.93, 0.94)
    g.print("Cairn", 80, 44)
    g.set_font(small)
    g.set_color(0.60, 0.65, 0.70)
    if #self.games == 0 then
        g.print("No games are installed here. cairn new DIR starts one; cairn play DIR plays it.", width / 2, height / 2,
            "center")
    end
    g.print("Arrows, mouse, finger or gamepad choose    Return plays    Escape quits    cairn help tells more", 80,
        height - 40)
end
