return {
    name = "The yard",
    gravity_y = -10,
    camera = { x = 0, y = 4, height = 12 },

    materials = {
        wood = { density = 0.7, friction = 0.6 },
        ice = { density = 0.9, friction = 0.03 },
    },
    templates = {
        crate = { shape = "box", width = 1, height = 1, material = "wood", data = { kind = "crate" } },
    },

    bodies = {
        -- Ground: a chain runs from right to left.
        { name = "ground", type = "static", shape = "chain", points = { { 30, 0 }, { 0, 0 }, { -30, 3 } } },
        { template = "crate", x = 2, y = 0.5 },
        { template = "crate", x = 2, y = 1.5, material = "ice" },
        { name = "hammer", x = 6, y = 3, shapes = {
            { shape = "box", width = 2, height = 0.2 },
            { shape = "circle", x = 1, radius = 0.4, density = 4 },
        } },
    },
    prefabs = {
        { name = "bridge", prefab = "bridge", x = 8, y = 2, to_x = 14, to_y = 2 },
    },
    joints = {
        -- Without body_a it holds to the world; "bridge.3" is the third body of a prefab.
        { name = "hinge", joint = "revolute", body_b = "hammer", x = 5, y = 3 },
    },
    triggers = {
        { name = "goal", shape = "box", x = 16, y = 1, width = 2, height = 2 },
    },
    spawns = {
        { name = "player", x = -3, y = 2 },
    },
    data = { stars = { 10, 20, 30 } },
}
