function cairn.load() end
