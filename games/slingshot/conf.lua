return {
    title = "Slingshot",
    identity = "slingshot",
    width = 1280, height = 720,
    background = { 0.44, 0.70, 0.82 },
}
