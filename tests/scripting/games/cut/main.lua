function cairn.udpate() end
