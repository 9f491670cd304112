-- One attempt at a level, from the first look to stars or none.
-- Invariant: `phase` goes aiming -> flying -> aiming ... -> won or lost; nothing but update, the recorded input and the
-- level decides how it goes, so a recorded match plays again to the same end. Things may go on falling after the end,
-- but points, stars and the number of grumps left are final.

local damage = require "src.damage"
local effects = require "src.effects"
local score = require "src.score"
local slingshot = require "src.slingshot"
local sound = require "src.sound"
local things = require "src.things"
local view = require "src.view"

local match = {}
match.__index = match

match.GRAVITY = -10

local LEAST_FLIGHT = 0.6        -- s before a shot may count as over
local LONGEST_FLIGHT = 9        -- s after which the next pebble is loaded even if something still moves
local LAST_LOOK = 2.2           -- s for the dust to settle after the last grump is gone
local TRAIL_INTERVAL = 3        -- updates between two dots of the trail
local BOUNDS = 28               -- m from the middle of the level; whatever is farther out is gone
local HEAVY_BLOW = 14           -- N s, from which dust rises and the picture shakes

match.STAR_TIMES = { 0.55, 0.95, 1.35 }   -- s after the end at which the stars appear

function match.new(level)
    local self = setmetatable({
        level = level,
        world = cairn.physics.new_world{ gravity_y = match.GRAVITY, hit_speed = 0.5 },
        slingshot = slingshot.new(level.slingshot.x),
        view = view.new(level.view),
        effects = effects.new(),
        pieces = {},
        grumps = {},
        pebble = nil,           -- the body of the last shot, until the next one is loaded
        trail = {},             -- { x1, y1, x2, y2, ... } of the last shot's free flight
        shots_left = level.shots,
        phase = "aiming",
        phase_time = 0,
        time = 0,
        points = 0,
        bonus = 0,
        stars = 0,
        grumps_left = nil,      -- at the end
        stars_heard = 0,        -- of those shown in the panel, how many have rung
    }, match)
    things.add_ground(self.world)
    for i, piece in ipairs(level.pieces) do
        self.pieces[i] = things.add_piece(self.world, piece, i)
    end
    for i, grump in ipairs(level.grumps) do
        self.grumps[i] = things.add_grump(self.world, grump)
    end
    return self
end

function match:destroy()
    self.world:destroy()
end

function match:is_over()
    return self.phase == "won" or self.phase == "lost"
end

function match:set_phase(phase)
    self.phase = phase
    self.phase_time = 0
end

-- ---- Aiming. Mouse positions are in pixels of the picture.

function match:grab(x, y)
    if self.phase == "aiming" and self.slingshot:grab(self.view.camera:to_world(x, y)) then
        sound.play("stretch", 0.5)
    end
end

function match:drag(x, y)
    self.slingshot:drag(self.view.camera:to_world(x, y))
end

--- The mouse lets go.
function match:release()
    if self.slingshot.held == "mouse" then
        self:shoot()
    end
end

--- Throws the pebble as far as the band is pulled.
function match:shoot()
    if self.phase ~= "aiming" then
        return
    end
    local x, y, vx, vy = self.slingshot:release()
    if not x then
        return
    end
    self.pebble = things.add_pebble(self.world, x, y, vx, vy)
    self.trail = {}
    self.shots_left = self.shots_left - 1
    self:set_phase("flying")
    sound.play("launch", 0.4 + 0.5 * math.sqrt(vx * vx + vy * vy) / slingshot.TOP_SPEED)
end

-- ---- Impacts

--- Points for what happens at (x, y), unless the match is over.
function match:gain(points, x, y, is_big)
    if self:is_over() then
        return
    end
    self.points = self.points + points
    self.effects:popup(tostring(points), x, y, is_big)
end

local function remove(list, body)
    for i, member in ipairs(list) do
        if member == body then
            table.remove(list, i)
            return
        end
    end
end

function match:break_piece(body)
    local piece, material = body.data, body.data.material
    local x, y = body:world_center()
    local vx, vy = body:linear_velocity()
    local size = math.sqrt(piece.area)
    self.effects:chips(x, y, vx, vy, math.floor(7 + 7 * size), 0.45 * size, material.chip)
    self.effects:puffs(x, y, 4, 0.55 * size, material.chip)
    self:gain(score.piece(material.score, piece.area), x, y, false)
    sound.burst(material.sounds.breaking)
    remove(self.pieces, body)
    body:destroy()
end

function match:lose_grump(body)
    local x, y = body:world_center()
    self.effects:puffs(x, y, 8, 0.6)
    self.effects:chips(x, y, 0, 1, 9, 0.2, { 0.43, 0.64, 0.25 })
    self:gain(score.GRUMP, x, y + 0.5, true)
    sound.burst("grump-pop")
    remove(self.grumps, body)
    body:destroy()
    self.last_loss_time = self.time
end

--- What an impulse does to one of the two bodies that met.
function match:strike(body, impulse)
    if not body:is_valid() then
        return
    end
    local thing = body.data
    if thing.kind == "piece" then
        sound.knock(thing.material.sounds.hits, impulse)
        if damage.strike(thing, impulse) then
            self:break_piece(body)
        end
    elseif thing.kind == "grump" then
        local health = thing.health
        if damage.strike(thing, impulse) then
            self:lose_grump(body)
        elseif thing.health < health then
            sound.burst("grump-mutter")
        end
    elseif thing.kind == "pebble" then
        sound.knock({ "pebble-hit" }, impulse)
        if not thing.has_touched then
            things.end_free_flight(body)
        end
    else
        sound.knock({ "thud" }, impulse)
    end
end

function match:apply_hits()
    for _, a, b, impulse, x, y in self.world:events("hit") do
        if impulse > HEAVY_BLOW then
            self.effects:puffs(x, y, 2, math.min(0.7, 0.2 + impulse / 90))
            self.view:shake_by((impulse - HEAVY_BLOW) / 50)
        end
        self:strike(a, impulse)
        self:strike(b, impulse)
    end
end

function match:is_outside(body)
    local x, y = body:position()
    return math.abs(x - self.level.view.x) > BOUNDS or y < -3
end

--- Takes away what left the level; a grump that did is as good as popped.
function match:remove_strays()
    for i = #self.pieces, 1, -1 do
        if self:is_outside(self.pieces[i]) then
            table.remove(self.pieces, i):destroy()
        end
    end
    for i = #self.grumps, 1, -1 do
        if self:is_outside(self.grumps[i]) then
            self:lose_grump(self.grumps[i])
        end
    end
    if self.pebble and self:is_outside(self.pebble) then
        self.pebble:destroy()
        self.pebble = nil
    end
end

-- ---- The course of a shot

function match:extend_trail()
    if self.pebble and not self.pebble.data.has_touched and self.world:step_count() % TRAIL_INTERVAL == 0 then
        local x, y = self.pebble:position()
        self.trail[#self.trail + 1] = x
        self.trail[#self.trail + 1] = y
    end
end

function match:is_shot_over()
    if #self.grumps == 0 and self.time > self.last_loss_time + LAST_LOOK then
        return true
    end
    local is_at_rest = self.phase_time > LEAST_FLIGHT and self.world:awake_count() == 0
    return is_at_rest or self.phase_time > LONGEST_FLIGHT
end

function match:end_shot()
    if #self.grumps == 0 then
        self:finish("won")
    elseif self.shots_left == 0 then
        self:finish("lost")
    else
        if self.pebble then
            local x, y = self.pebble:position()
            self.effects:puffs(x, y, 6, 0.5)
            self.pebble:destroy()
            self.pebble = nil
        end
        self:set_phase("aiming")
    end
end

function match:finish(outcome)
    self.grumps_left = #self.grumps
    if outcome == "won" then
        self.bonus = score.bonus(self.shots_left)
        self.points = self.points + self.bonus
        self.stars = score.stars(self.points, self.level.stars)
    end
    self:set_phase(outcome)
    sound.play(outcome == "won" and "win" or "lose")
    cairn.result{ outcome = outcome, level = self.level.id, score = self.points, stars = self.stars }
end

--- How many of the stars have appeared in the panel.
function match:shown_stars()
    local shown = 0
    for i = 1, self.stars do
        if self.phase == "won" and self.phase_time >= match.STAR_TIMES[i] then
            shown = i
        end
    end
    return shown
end

function match:update(dt)
    self.time = self.time + dt
    self.phase_time = self.phase_time + dt
    if self.phase == "aiming" then
        self.slingshot:update_keys(dt, cairn.input.is_down)
    end
    self.world:step(dt)
    self:apply_hits()
    self:remove_strays()
    if self.phase == "flying" then
        self:extend_trail()
    elseif self:shown_stars() > self.stars_heard then
        self.stars_heard = self:shown_stars()
        sound.play("star", 0.8, 0.9 + 0.12 * self.stars_heard)
    end
    -- Without grumps there is nothing left to aim at, even if no shot brought that about.
    if self.phase == "flying" or (self.phase == "aiming" and #self.grumps == 0) then
        if self:is_shot_over() then
            self:end_shot()
        end
    end
    self.effects:update(dt)
    if self.phase == "flying" and self.pebble then
        self.view:update(dt, self.pebble:position())
    else
        self.view:update(dt)
    end
end

return match
