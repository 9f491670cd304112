-- Level files: what they may hold, and how they are read. README.md in the game's folder describes the format.
-- Invariant: a level is data: loading one runs nothing, and a fault is an error that names line, field and rule.

local materials = require "src.materials"

local level = {}

-- A piece's texture is cut out of one that shows 3 m (see outline.lua), so none may be longer.
local MAX_SIDE = 3.0

local place = { type = "number", required = true, min = -50, max = 50 }
local points = { type = "integer", required = true, min = 0 }

--- Text that is shown must be what fonts can draw.
local function check_utf8(text)
    local _, bad_byte = utf8.len(text)
    if bad_byte then
        return ("must be valid UTF-8; byte %d is not"):format(bad_byte)
    end
end

local function check_stars(stars)
    if stars.two > stars.three then
        return ("two = %d must not be above three = %d"):format(stars.two, stars.three)
    end
end

local piece = { type = "table", fields = {
    material = { type = "string", required = true, what = "material", one_of = materials },
    shape = { type = "string", default = "box", what = "shape", one_of = { "box", "triangle" } },
    x = place,
    y = place,
    width = { type = "number", required = true, min = 0.1, max = MAX_SIDE },
    height = { type = "number", required = true, min = 0.1, max = MAX_SIDE },
    angle = { type = "number", default = 0, min = -180, max = 180 },
} }

local grump = { type = "table", fields = {
    x = place,
    y = place,
} }

level.schema = { type = "table", fields = {
    name = { type = "string", required = true, min_length = 1, max_length = 40, check = check_utf8 },
    hint = { type = "string", default = "", max_length = 80, check = check_utf8 },
    shots = { type = "integer", required = true, min = 1, max = 8 },
    view = { type = "table", required = true, fields = {
        x = place,
        y = place,
        height = { type = "number", required = true, min = 4, max = 40 },
    } },
    slingshot = { type = "table", required = true, fields = { x = place } },
    stars = { type = "table", required = true, fields = { two = points, three = points }, check = check_stars },
    pieces = { type = "list", required = true, min_length = 1, items = piece },
    grumps = { type = "list", required = true, min_length = 1, items = grump },
} }

--- Reads levels/ID.lua. The level's id is the name of its file.
function level.load(id)
    local loaded = cairn.data.load("levels/" .. id .. ".lua", level.schema)
    loaded.id = id
    return loaded
end

return level
