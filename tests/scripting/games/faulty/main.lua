function cairn.load()
    if then
end
