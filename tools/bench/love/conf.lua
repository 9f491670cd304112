-- Neither window nor sound: only Lua and the physics are measured.
function love.conf(t)
    for _, module in ipairs{ "audio", "font", "graphics", "image", "joystick", "keyboard", "mouse", "sound", "touch", "video", "window" } do
        t.modules[module] = false
    end
end
