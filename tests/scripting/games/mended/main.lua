-- Fails after half a second; mend_game.sh saves what follows from this text.
local world, ball
local updates = 0
function cairn.load()
    print("loaded")
    world = cairn.physics.new_world{ gravity_y = -10 }
    ball = world:add_circle{ radius = 1, y = 100 }
end
function cairn.update(dt)
    updates = updates + 1
    world:step(dt)
    if updates == 30 then error("slip") end
end
function cairn.before_reload() return { world = world, ball = ball } end
function cairn.after_reload(kept)
    world, ball = kept.world, kept.ball
    print(("kept at %.2f"):format(select(2, ball:position())))
    cairn.quit()
end
