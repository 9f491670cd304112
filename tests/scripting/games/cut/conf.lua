return {
    widht = 640,
    height = "tall",
}
