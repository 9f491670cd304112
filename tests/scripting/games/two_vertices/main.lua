local world = cairn.physics.new_world{}

function cairn.load()
    world:add_polygon{ points = { { 0, 0 }, { 1, 0 } } }
end
