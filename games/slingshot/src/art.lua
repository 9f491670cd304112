-- The pictures and their measures.
-- Invariant: tools/art draws things of the world at 100 pixels to the metre; the centres here are those it drew around.

local art = {
    SCALE = 0.01,                                   -- metres per pixel
    PEBBLE = { x = 40, y = 40 },
    GRUMP = { x = 60, y = 82 },
    SLINGSHOT = { x = 82, y = 276 },                -- where the trunk meets the ground
    CORD_FRONT = { x = -0.44, y = 2.33 },           -- metres from there
    CORD_BACK = { x = 0.42, y = 2.33 },
    GROUND_LINE = 30,                               -- pixels of blades above the surface
    INK = { 0.29, 0.196, 0.188 },
    CREAM = { 1.0, 0.953, 0.863 },
}

local NAMES = {
    "wood", "stone", "ice", "cracks-1", "cracks-2", "cracks-3", "splinters-1", "splinters-2", "splinters-3",
    "pebble", "grump", "grump-blink", "grump-hurt", "fork-front", "fork-back", "sky", "cloud-1", "cloud-2",
    "hills-far", "hills-middle", "hills-near", "ground", "tuft", "cairn", "star-full", "star-empty",
    "button-restart", "button-pause", "puff", "shadow",
}

local images = {}

function art.load()
    for _, name in ipairs(NAMES) do
        images[name] = cairn.graphics.new_image("images/" .. name .. ".png")
    end
end

function art.image(name)
    return images[name]
end

return art
