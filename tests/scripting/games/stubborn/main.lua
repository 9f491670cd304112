function cairn.load() print("ready") end
function cairn.quit_requested() return true end
