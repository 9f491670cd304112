local materials = { wood = { density = 1 }, stone = { density = 3 }, ice = { density = 0.9 } }
cairn.data.load("levels/one.lua", { type = "table", fields = {
    pieces = { type = "list", required = true, items = { type = "table", fields = {
        material = { type = "string", required = true, what = "material", one_of = materials },
    } } },
} })
