-- Two towers, a bridge between them, and a cairn on the bridge. One grump looks out of the left tower; the other one
-- has built himself a shelter under the cairn.
return {
    name = "Gatehouse",
    hint = "Pull the pebble back and let go",
    shots = 3,
    view = { x = 6.6, y = 4.15, height = 10.8 },
    slingshot = { x = 0 },
    stars = { two = 13000, three = 15000 },

    pieces = {
        -- left tower: wooden ground floor, icy upper floor
        { material = "wood",  x =  8.60, y = 0.85, width = 0.44, height = 1.70 },
        { material = "wood",  x = 10.20, y = 0.85, width = 0.44, height = 1.70 },
        { material = "wood",  x =  9.40, y = 1.89, width = 2.40, height = 0.38 },
        { material = "ice",   x =  8.60, y = 2.78, width = 0.40, height = 1.40 },
        { material = "ice",   x = 10.20, y = 2.78, width = 0.40, height = 1.40 },
        { material = "wood",  x =  9.40, y = 3.66, width = 2.30, height = 0.36 },
        { material = "wood",  x =  8.90, y = 4.24, width = 1.30, height = 0.80, shape = "triangle" },

        -- right tower: stone below, wood above
        { material = "stone", x = 13.00, y = 0.85, width = 0.50, height = 1.70 },
        { material = "stone", x = 14.60, y = 0.85, width = 0.50, height = 1.70 },
        { material = "wood",  x = 13.80, y = 1.89, width = 2.40, height = 0.38 },
        { material = "wood",  x = 13.00, y = 2.78, width = 0.40, height = 1.40 },
        { material = "wood",  x = 14.60, y = 2.78, width = 0.40, height = 1.40 },
        { material = "wood",  x = 13.80, y = 3.66, width = 2.30, height = 0.36 },
        { material = "wood",  x = 14.30, y = 4.24, width = 1.30, height = 0.80, shape = "triangle" },

        -- bridge with its cairn
        { material = "wood",  x = 11.60, y = 4.00, width = 2.90, height = 0.32 },
        { material = "stone", x = 11.60, y = 4.41, width = 1.00, height = 0.50 },
        { material = "stone", x = 11.60, y = 4.87, width = 0.74, height = 0.42 },
        { material = "stone", x = 11.60, y = 5.24, width = 0.48, height = 0.32 },

        -- shelter under the bridge
        { material = "stone", x = 11.00, y = 0.50, width = 0.34, height = 1.00 },
        { material = "stone", x = 12.20, y = 0.50, width = 0.34, height = 1.00 },
        { material = "ice",   x = 11.60, y = 1.14, width = 1.80, height = 0.28 },
    },

    grumps = {
        { x =  9.40, y = 2.50 },
        { x = 11.60, y = 0.42 },
    },
}
