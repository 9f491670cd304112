-- Sounds, with what keeps a heap of falling pieces from sounding like a machine: louder and deeper with the impulse, a
-- little different each time, and not too many at once.
-- Invariant: nothing here changes the game; all chance is from the visual stream.

local sound = {}

local NAMES = {
    "wood-hit-1", "wood-hit-2", "wood-hit-3", "stone-hit-1", "stone-hit-2", "stone-hit-3",
    "ice-hit-1", "ice-hit-2", "ice-hit-3", "wood-break", "stone-break", "ice-break",
    "stretch", "launch", "pebble-hit", "grump-mutter", "grump-pop", "thud", "star", "win", "lose", "button",
}

-- Impulses (N s) of the faintest knock that is heard and of one at full volume.
local FAINTEST, LOUDEST = 0.8, 30

local function path(name)
    return "sounds/" .. name .. ".wav"
end

function sound.load()
    for _, name in ipairs(NAMES) do
        cairn.audio.set_rate_cap(path(name), 0.07, 3)
    end
end

function sound.play(name, volume, pitch)
    cairn.audio.play(path(name), { volume = volume or 0.8, pitch = pitch or 1 })
end

--- A knock of an impulse against something that sounds like one of the names.
function sound.knock(names, impulse)
    if impulse < FAINTEST then
        return
    end
    local chance = cairn.random.visual
    local loudness = math.min(1, math.sqrt((impulse - FAINTEST) / (LOUDEST - FAINTEST)))
    local name = names[chance:integer(1, #names)]
    sound.play(name, 0.12 + 0.75 * loudness, 1.12 - 0.16 * loudness + chance:number(-0.06, 0.06))
end

--- Something breaks or bursts, with some change of pitch.
function sound.burst(name)
    sound.play(name, 0.9, cairn.random.visual:number(0.93, 1.08))
end

return sound
