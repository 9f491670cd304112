-- Makes the bodies of a level: ground, pieces, grumps, pebbles.
-- Invariant: body.data.kind says which of them a body is; pieces and grumps also have `health` and `strength`.

local damage = require "src.damage"
local materials = require "src.materials"
local outline = require "src.outline"

local things = {}

things.PEBBLE_RADIUS = 0.33
things.GRUMP_RADIUS = 0.42

local GROUND_HALF_WIDTH = 60

-- A pebble weighs as much as a big plank of wood, so that it shoves what it hits. It slows down as soon as it has
-- touched something, as on grass; before that it flies as the preview says.
local PEBBLE = { density = 7, friction = 0.7, restitution = 0.25 }
local PEBBLE_ROLLING_DAMPING, PEBBLE_DRAG = 2.0, 0.5

local GRUMP = { density = 2.5, friction = 0.8, restitution = 0.1, strength = 9, angular_damping = 1 }

function things.add_ground(world)
    return world:add_box{
        type = "static", x = 0, y = -1, width = 2 * GROUND_HALF_WIDTH, height = 2, friction = 0.8,
        data = { kind = "ground" },
    }
end

--- A piece as a level describes it. `variant` is its number: it chooses the part of the texture that it shows.
function things.add_piece(world, piece, variant)
    local material = materials[piece.material]
    local corners = outline.corners(piece.shape, piece.width, piece.height)
    local area = outline.area(corners)
    local flat = outline.rounded(corners, 0)
    local turned = material.along_grain and piece.height > piece.width
    return world:add_polygon{
        x = piece.x, y = piece.y, angle = math.rad(piece.angle), points = corners,
        density = material.density, friction = material.friction, restitution = material.restitution,
        data = {
            kind = "piece",
            material = material,
            area = area,
            health = 1,
            strength = damage.strength(material.strength, area),
            outline = flat,
            bevel = outline.rounded(corners, 0.05),
            texture_places = outline.texture_places(flat, piece.width, piece.height, turned, variant),
        },
    }
end

--- A grump collides as an octagon with a flat side down, so that it sits and does not roll away.
function things.add_grump(world, grump)
    local r = things.GRUMP_RADIUS
    local near, far = r * math.tan(math.pi / 8), r
    return world:add_polygon{
        x = grump.x, y = grump.y,
        points = {
            { -near, -far }, { near, -far }, { far, -near }, { far, near },
            { near, far }, { -near, far }, { -far, near }, { -far, -near },
        },
        density = GRUMP.density, friction = GRUMP.friction, restitution = GRUMP.restitution,
        angular_damping = GRUMP.angular_damping,
        data = { kind = "grump", health = 1, strength = GRUMP.strength },
    }
end

function things.add_pebble(world, x, y, vx, vy)
    return world:add_circle{
        x = x, y = y, linear_velocity_x = vx, linear_velocity_y = vy, radius = things.PEBBLE_RADIUS,
        density = PEBBLE.density, friction = PEBBLE.friction, restitution = PEBBLE.restitution,
        data = { kind = "pebble", has_touched = false },
    }
end

--- The pebble has met something for the first time: its free flight is over.
function things.end_free_flight(pebble)
    pebble.data.has_touched = true
    pebble:set_angular_damping(PEBBLE_ROLLING_DAMPING)
    pebble:set_linear_damping(PEBBLE_DRAG)
end

return things
