-- What is being played: one match at a time, which may be paused and started again.
-- Invariant: a restarted match is the same as a fresh one; nothing is carried over.

local level = require "src.level"
local match = require "src.match"

local game = { match = nil, paused = false }

function game.start(level_name)
    if game.match then
        game.match:destroy()
    end
    game.match = match.new(level.load(level_name))
    game.paused = false
end

function game.restart()
    game.start(game.match.level.id)
end

--- A pebble that the mouse holds is put back: the mouse may be let go elsewhere meanwhile.
function game.pause()
    game.paused = not game.match:is_over()
    game.match.slingshot:drop()
end

function game.toggle_pause()
    if game.paused then
        game.paused = false
    else
        game.pause()
    end
end

function game.update(dt)
    if not game.paused then
        game.match:update(dt)
    end
end

return game
