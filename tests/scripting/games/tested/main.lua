local count = 0
function cairn.key_pressed(key)
    if key == "space" then count = count + 1 end
end
function cairn.update()
    if count == 2 then cairn.result{ outcome = "won", score = count } end
end
