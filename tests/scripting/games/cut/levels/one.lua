return {
    bodies = {
        { name = "the ball", shape = "circle", radius = 1 },
        { name = "crate", template = "wooden", shape = "box" },
        { name = "kite", shape = "polygon", points = { { 0, 0 }, { 2, 2 }, { 2, 0 }, { 0, 2 } } },
        { name = "star", shape = "circle", radius = 1, x = 1e300 },
    },
    joints = {
        { joint = "revolute", body_a = "the ball", body_b = "crate", x = 0, y = 0 },
        { joint = "revolute", body_a = "kite", body_b = "star", x = 0, y = 0 },
    },
}
