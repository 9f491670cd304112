-- A title menu, an options menu whose settings are saved, and a page where keys are bound anew.
-- Arrow keys and Return, the mouse, a finger or a gamepad, whichever is at hand.
local g = cairn.graphics
local settings = { sound = true, volume = 7, detail = 2, name = "Player" }
local keys = { jump = { "space", "gamepad_a" }, fire = { "x", "mouse_left" } }
local title, options, controls = {}, {}, {}

local function save() cairn.files.write_data("save/settings.lua", settings) end

function cairn.load()
    if cairn.files.exists("save/settings.lua") then
        for name, value in cairn.sorted_pairs(cairn.files.read_data("save/settings.lua")) do settings[name] = value end
    end
    for action, sources in cairn.sorted_pairs(keys) do cairn.input.bind(action, sources) end
    cairn.scene.push(title)
end

-- What all three scenes share: a menu on a drifting background.
local function scene_of(scene, build)
    function scene:enter()
        self.menu = build(self)
        self.time = 0
    end
    function scene:update(dt)
        self.time = self.time + dt
        self.menu:update()
    end
    function scene:draw()
        g.clear(0.13, 0.17, 0.24)
        for i = 0, 11 do
            g.set_color(0.18, 0.24, 0.33)
            local x = (i * 137 + 18 * self.time) % 1400 - 60
            g.circle("fill", x, 90 + (i * 223) % 600, 30 + i * 5)
        end
        self.menu:draw()
    end
end

scene_of(title, function()
    local menu = cairn.ui.new{ title = "Menus" }
    menu:add_button{ text = "Options", action = function() cairn.scene.push(options) end }
    menu:add_button{ text = "Controls", action = function() cairn.scene.push(controls) end }
    menu:add_button{ text = "Continue", enabled = false }
    menu:add_button{ text = "Quit", action = cairn.quit }
    return menu
end)

scene_of(options, function()
    local menu = cairn.ui.new{ title = "Options", width = 560, back = cairn.scene.pop }
    local volume
    menu:add_toggle{ text = "Sound", value = settings.sound, changed = function(on)
        settings.sound = on
        menu:set_enabled(volume, on)
    end }
    volume = menu:add_slider{ text = "Volume", value = settings.volume, high = 10, step = 1,
        enabled = settings.sound, changed = function(value) settings.volume = value end }
    menu:add_choice{ text = "Detail", choices = { "low", "middle", "high" }, value = settings.detail,
        changed = function(number) settings.detail = number end }
    menu:add_text{ text = "Name", value = settings.name, max_length = 12,
        changed = function(text) settings.name = text end }
    menu:add_label{ text = "Kept in the save folder." }
    menu:add_button{ text = "Save", action = function() save() cairn.scene.pop() end }
    menu:add_button{ text = "Back", same_row = true, action = function() cairn.scene.pop() end }
    return menu
end)

scene_of(controls, function()
    local menu = cairn.ui.new{ title = "Controls", width = 640, accent = { 0.5, 0.8, 1 }, back = cairn.scene.pop }
    for _, action in ipairs(cairn.input.actions()) do
        local button
        local function show() menu:set_text(button, action .. ":  " .. table.concat(cairn.input.sources(action), ", ")) end
        button = menu:add_button{ action = function()
            menu:set_text(button, action .. ":  press a key or a button ...")
            cairn.input.listen(function(source)
                cairn.input.bind(action, { source })
                show()
            end)
        end }
        show()
    end
    menu:add_button{ text = "Back", action = function() cairn.scene.pop() end }
    return menu
end)
