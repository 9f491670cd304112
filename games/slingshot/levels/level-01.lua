-- Two towers, a bridge between them, and a cairn on the bridge. One grump looks out of the left tower; the other one
-- has made himself comfortable under the cairn.
return {
    name = "Gatehouse",
    hint = "Pull the pebble back and let go",
    shots = 3,
    view = { x = 6.4, y = 3.55, height = 10.6 },
    slingshot = { x = 0 },
    stars = { two = 12000, three = 16000 },

    pieces = {
        -- left tower: wooden ground floor, icy upper floor
        { material = "wood",  x =  9.80, y = 0.85, width = 0.44, height = 1.70 },
        { material = "wood",  x = 11.40, y = 0.85, width = 0.44, height = 1.70 },
        { material = "wood",  x = 10.60, y = 1.89, width = 2.40, height = 0.38 },
        { material = "ice",   x =  9.80, y = 2.78, width = 0.40, height = 1.40 },
        { material = "ice",   x = 11.40, y = 2.78, width = 0.40, height = 1.40 },
        { material = "wood",  x = 10.60, y = 3.66, width = 2.30, height = 0.36 },
        { material = "wood",  x = 10.10, y = 4.24, width = 1.30, height = 0.80, shape = "triangle" },

        -- right tower: stone below, wood above
        { material = "stone", x = 14.20, y = 0.85, width = 0.50, height = 1.70 },
        { material = "stone", x = 15.80, y = 0.85, width = 0.50, height = 1.70 },
        { material = "wood",  x = 15.00, y = 1.89, width = 2.40, height = 0.38 },
        { material = "wood",  x = 14.20, y = 2.78, width = 0.40, height = 1.40 },
        { material = "wood",  x = 15.80, y = 2.78, width = 0.40, height = 1.40 },
        { material = "wood",  x = 15.00, y = 3.66, width = 2.30, height = 0.36 },
        { material = "wood",  x = 15.50, y = 4.24, width = 1.30, height = 0.80, shape = "triangle" },

        -- bridge with its cairn
        { material = "wood",  x = 12.80, y = 4.00, width = 2.90, height = 0.32 },
        { material = "stone", x = 12.80, y = 4.41, width = 1.00, height = 0.50 },
        { material = "stone", x = 12.80, y = 4.87, width = 0.74, height = 0.42 },
        { material = "stone", x = 12.80, y = 5.24, width = 0.48, height = 0.32 },
    },

    grumps = {
        { x = 10.60, y = 2.50 },
        { x = 12.80, y = 0.42 },
    },
}
