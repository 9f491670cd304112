return {
    title = "Cairn",
    width = 1280, height = 720,
    background = { 0.10, 0.12, 0.15 },
}
