-- The camera: frames the level, leans after the shot, grows when the shot flies high, shakes with heavy blows.
-- Invariant: the `camera` that turns mouse positions into places in the world moves in updates only and never shakes,
-- so aiming depends on nothing but recorded input; the `lens` that is drawn with lies between two of its places.

local view = {}
view.__index = view

local LEAN = 0.14               -- share of the shot's distance from the middle that the camera follows
local MAX_LEAN = 1.3            -- m
local HEADROOM = 0.9            -- kept above the shot, m
local HIGHEST = 1.5             -- greatest height, as a multiple of the level's
local FOLLOW_TIME = 0.45        -- s to cover 63 % of the way to where the camera wants to be
local SHAKE_TIME = 0.16         -- s in which a shake falls to 37 %
local SHAKE_PIXELS = 7

function view.new(frame)
    local place = { x = frame.x, y = frame.y, height = frame.height }
    return setmetatable({
        frame = frame,
        camera = cairn.camera.new(place),
        lens = cairn.camera.new(place),
        before = { x = frame.x, height = frame.height },
        now = { x = frame.x, height = frame.height },
        shake = 0,
        time = 0,
    }, view)
end

--- The middle of a picture of that height whose lower edge is the level's.
local function middle(frame, height)
    return frame.y + (height - frame.height) / 2
end

--- One update; (shot_x, shot_y) is where the shot flies, if one does.
function view:update(dt, shot_x, shot_y)
    local frame, now = self.frame, self.now
    local x, height = frame.x, frame.height
    if shot_x then
        x = x + math.max(-MAX_LEAN, math.min(MAX_LEAN, LEAN * (shot_x - frame.x)))
        local bottom = frame.y - frame.height / 2
        height = math.max(height, math.min(HIGHEST * frame.height, shot_y + HEADROOM - bottom))
    end
    local share = 1 - math.exp(-dt / FOLLOW_TIME)
    self.before.x, self.before.height = now.x, now.height
    now.x = now.x + (x - now.x) * share
    now.height = now.height + (height - now.height) * share
    self.camera:set_height(now.height)
    self.camera:set_position(now.x, middle(frame, now.height))
    self.time = self.time + dt
    self.shake = self.shake * math.exp(-dt / SHAKE_TIME)
end

--- A blow; strength 1 is the heaviest.
function view:shake_by(strength)
    self.shake = math.min(1, math.max(self.shake, strength))
end

--- Moves the lens to between the last two updates and returns it.
function view:lens_at(alpha)
    local height = self.before.height + (self.now.height - self.before.height) * alpha
    self.lens:set_height(height)
    self.lens:set_position(self.before.x + (self.now.x - self.before.x) * alpha, middle(self.frame, height))
    local reach = SHAKE_PIXELS * self.shake
    self.lens:set_shake(reach * math.sin(self.time * 61), reach * math.sin(self.time * 47 + 1))
    return self.lens
end

return view
