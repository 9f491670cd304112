local function fail_at(frame)
    if cairn.timer.frame() == frame then error("frame " .. frame .. " is cursed") end
end

function cairn.update()
    fail_at(3)
end
