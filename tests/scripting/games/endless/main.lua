function cairn.load()
    print("ready")
    while true do end
end
