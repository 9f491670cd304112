function cairn.load()
    local x = = 1
end
