return {
    bodies = {
        { shape = "circle", radius = 0 },
        { shape = "sircle", radius = 1 },
    },
}
