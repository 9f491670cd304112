-- What pieces are made of. A level names one of these for each piece.
--
--   density      kg per square metre
--   friction, restitution   as for every shape
--   strength     N s: the impulse that breaks a piece of one square metre at one blow; see damage.lua
--   score        points for breaking a piece of one square metre
--   texture, cracks   pictures; cracks has one for each of the three states of damage
--   along_grain  the texture follows the longer side
--   chip         color of the bits that fly off
--   sounds       names of hits, one of which is chosen at each, and of the breaking

return {
    wood = {
        name = "wood",
        density = 2.0, friction = 0.6, restitution = 0.05, strength = 16, score = 600,
        texture = "wood", cracks = { "splinters-1", "splinters-2", "splinters-3" }, along_grain = true,
        chip = { 0.86, 0.65, 0.39 },
        sounds = { hits = { "wood-hit-1", "wood-hit-2", "wood-hit-3" }, breaking = "wood-break" },
    },
    stone = {
        name = "stone",
        density = 5.0, friction = 0.7, restitution = 0.02, strength = 48, score = 1000,
        texture = "stone", cracks = { "cracks-1", "cracks-2", "cracks-3" }, along_grain = false,
        chip = { 0.66, 0.65, 0.70 },
        sounds = { hits = { "stone-hit-1", "stone-hit-2", "stone-hit-3" }, breaking = "stone-break" },
    },
    ice = {
        name = "ice",
        density = 1.8, friction = 0.25, restitution = 0.05, strength = 7, score = 400,
        texture = "ice", cracks = { "cracks-1", "cracks-2", "cracks-3" }, along_grain = false,
        chip = { 0.80, 0.94, 0.98 },
        sounds = { hits = { "ice-hit-1", "ice-hit-2", "ice-hit-3" }, breaking = "ice-break" },
    },
}
