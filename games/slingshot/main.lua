-- Slingshot: throw pebbles at the grumps that moved into the stone-stackers' towers.
-- This file only connects Cairn's callbacks to the game.

local game = require "src.game"
local hud = require "src.hud"
local picture = require "src.picture"
local sound = require "src.sound"

function cairn.load()
    sound.load()
    picture.load()
    hud.load()
    game.start("level-01")
end

function cairn.update(dt)
    game.update(dt)
end

function cairn.draw(alpha)
    picture.draw(game.match, alpha)
    hud.draw(game.match, game.paused)
end

function cairn.key_pressed(key, is_repeat)
    if is_repeat then
        return
    end
    if key == "r" or (key == "return" and game.match:is_over()) then
        game.restart()
    elseif key == "p" or key == "escape" then
        game.toggle_pause()
    elseif key == "space" and not game.paused then
        game.match:shoot()
    end
end

function cairn.mouse_pressed(x, y, button)
    if button ~= "left" then
        return
    end
    local action = hud.action_at(game.match, x, y)
    if action then
        sound.play("button")
        game[action]()
    elseif not game.paused then
        game.match:grab(x, y)
    end
end

function cairn.mouse_moved(x, y)
    if not game.paused then
        game.match:drag(x, y)
    end
end

function cairn.mouse_released(_, _, button)
    if button == "left" and not game.paused then
        game.match:release()
    end
end

function cairn.focus(has_focus)
    if not has_focus then
        game.pause()
    end
end
