function cairn.update()
    if cairn.timer.frame() == 5 then
        cairn.result{ outcome = "won", level = "one", score = 1234, stars = 2 }
        cairn.quit()
    end
end
