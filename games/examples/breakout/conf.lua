return {
    title = "Breakout",
    identity = "example-breakout",
    width = 960, height = 720,
}
