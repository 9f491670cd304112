-- As many bodies as it has been played before.
function cairn.load()
    local world = cairn.physics.new_world{}
    local played = cairn.files.exists("save/played.lua") and cairn.files.read_data("save/played.lua").times or 0
    for i = 1, played do world:add_circle{ x = i, radius = 0.3 } end
    cairn.files.write_data("save/played.lua", { times = played + 1 })
end
