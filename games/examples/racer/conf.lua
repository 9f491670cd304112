return {
    title = "Racer",
    identity = "example-racer",
    width = 1280, height = 720,
}
