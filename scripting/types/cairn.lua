---@meta
-- Written by `cairn help --types`: annotations for the Lua language server. Never run.

cairn = {}

---Ends the game after this frame.
function cairn.quit() end

---@class cairn.result.Fields
---@field outcome string "won", "lost", ...
---@field level? string
---@field score? number
---@field stars? integer

---Reports how a level ended. Headless runs print the last report.
---@param fields cairn.result.Fields
function cairn.result(fields) end

---Iterates like `pairs`, in one fixed order: numbers ascending, then strings bytewise, then false, true. Plain `pairs` visits keys that are not list indices in an order that differs between runs, because Lua seeds its string hash anew in each process; whatever that order decides would break replays. Use `ipairs` or `sorted_pairs` for all that gameplay depends on.
---@param t table
---@return fun(): any, any iterator
function cairn.sorted_pairs(t) end

cairn.physics = {}

---@class cairn.physics.new_world.Fields
---@field gravity_x? number m/s^2
---@field gravity_y? number m/s^2
---@field substeps? integer from 1 to 64; solver passes per step
---@field sleep? boolean whether resting bodies stop being computed
---@field hit_speed? number at least 0; m/s; the least approach speed that makes a "hit" event
---@field restitution_speed? number at least 0; m/s; slower approaches do not bounce
---@field max_push_out_speed? number above 0; m/s; how fast overlap is undone at most
---@field joint_solver? string "automatic", "sweeping" (cheapest) or "direct" (all structures at once, whatever it costs)
---@field threads? integer from 1 to 64; that share a step; the results do not depend on it

---Makes an empty world. It lives until `world:destroy()`.
---@param fields cairn.physics.new_world.Fields?
---@return World world
function cairn.physics.new_world(fields) end

---@class cairn.physics.define_material.Fields
---@field density? number at least 0; kg/m^2; a dynamic body whose shapes all have 0 has no mass: no force moves it, gravity neither, and only its velocity, if it is given one, does
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by

---Gives what shapes are made of a name: after `cairn.physics.define_material("wood", { density = 0.7, friction = 0.6 })` the field `material = "wood"` stands for these, wherever a shape is made or its material set. Fields that stand beside it go before. Where two shapes touch their values mix as ever. Naming it again is for shapes that are made from then on. Levels have materials of their own; a file of materials can be included by levels and named here: `for name, fields in pairs(require("materials").materials) do cairn.physics.define_material(name, fields) end`.
---@param name string
---@param fields cairn.physics.define_material.Fields
function cairn.physics.define_material(name, fields) end

---A new table of those that have names: name -> all their fields.
---@return table materials
function cairn.physics.materials() end

---Makes an empty list of places for `world:read_transforms`.
---@return Transforms transforms
function cairn.physics.new_transforms() end

---@class cairn.physics.new_recording.Fields
---@field states_between_whole_ones? integer from 1 to 10000; every so many states one is kept whole: seeking applies at most so many differences

---Makes an empty recording, for the states of a world.
---@param fields cairn.physics.new_recording.Fields?
---@return Recording recording
function cairn.physics.new_recording(fields) end

---What turns the bytes of one snapshot into those of another, as a string: small when little differs, as from step to step. To be sent or saved.
---@param base string
---@param target string
---@return string delta
function cairn.physics.make_delta(base, target) end

---The bytes of a snapshot from those of the one before it and what `make_delta` gave; an error when `base` is another one.
---@param base string
---@param delta string
---@return string target
function cairn.physics.apply_delta(base, delta) end

---Whether this build of Cairn has a part of the physics that can be left out: "joints", "sensors", "chains", "fracture" and so on. Using one that is left out is an error that names it.
---@param feature string
---@return boolean built_in
function cairn.physics.is_built_in(feature) end

---The way nearest to a wanted one that stays `gap` in front of every plane that `world:collision_planes` told: for characters of your own. Where there is none, planes of dynamic bodies give way first.
---@param dx number [m]
---@param dy number [m]
---@param planes table
---@param gap number [m] at least 0
---@return number dx [m]
---@return number dy [m]
function cairn.physics.solve_planes(dx, dy, planes, gap) end

---@class cairn.physics.new_mover.Fields
---@field x? number m; of the feet
---@field y? number m
---@field height? number above 0; m, of the capsule, from its feet up
---@field radius? number above 0; m; less than half the height
---@field up_x? number a direction of any length
---@field up_y? number
---@field max_slope? number from 0 to 1.570796; rad; steeper ground is a wall
---@field step_height? number at least 0; m; steps up to this are walked over
---@field push_force? number at least 0; N; at most, against dynamic bodies in the way

---Makes a character that walks.
---@param fields cairn.physics.new_mover.Fields?
---@return Mover mover
function cairn.physics.new_mover(fields) end

---@class World
local World = {}

---Moves the world on and replaces its events by those of this step.
---@param dt number [s] above 0 and at most 1
function World:step(dt) end

---@class World.new_body.Fields
---@field x? number from -1e+12 to 1e+12; m
---@field y? number from -1e+12 to 1e+12; m
---@field angle? number rad
---@field type? string "static", "kinematic" or "dynamic"
---@field linear_velocity_x? number m/s, of the centre of mass
---@field linear_velocity_y? number m/s, of the centre of mass
---@field angular_velocity? number rad/s
---@field linear_damping? number at least 0; 1/s; c in v e^(-c t)
---@field angular_damping? number at least 0; 1/s
---@field gravity_scale? number
---@field allow_sleep? boolean
---@field awake? boolean
---@field lock_x? boolean the centre of mass stays at its x
---@field lock_y? boolean the centre of mass stays at its y
---@field lock_rotation? boolean it does not turn
---@field sleep_speed? number at least 0; m/s; may sleep when slower than this for half a second; at 0 it never does
---@field data? table becomes body.data

---Adds a body without shapes; give it some with `body:add_box{...}` and the like.
---@param fields World.new_body.Fields
---@return Body body
function World:new_body(fields) end

---@class World.add_box.Fields
---@field width number above 0 and at most 2000000; m
---@field height number above 0 and at most 2000000; m
---@field radius? number from 0 to 1000000; m; rounds the corners outward
---@field x? number from -1e+12 to 1e+12; m
---@field y? number from -1e+12 to 1e+12; m
---@field angle? number rad
---@field type? string "static", "kinematic" or "dynamic"
---@field linear_velocity_x? number m/s, of the centre of mass
---@field linear_velocity_y? number m/s, of the centre of mass
---@field angular_velocity? number rad/s
---@field linear_damping? number at least 0; 1/s; c in v e^(-c t)
---@field angular_damping? number at least 0; 1/s
---@field gravity_scale? number
---@field allow_sleep? boolean
---@field awake? boolean
---@field lock_x? boolean the centre of mass stays at its x
---@field lock_y? boolean the centre of mass stays at its y
---@field lock_rotation? boolean it does not turn
---@field sleep_speed? number at least 0; m/s; may sleep when slower than this for half a second; at 0 it never does
---@field data? table becomes body.data
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field density? number at least 0; kg/m^2; a dynamic body whose shapes all have 0 has no mass: no force moves it, gravity neither, and only its velocity, if it is given one, does
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field sensor? boolean collides with nothing; `world:sensor_events()` tells what comes to overlap it
---@field seen_by_sensors? boolean
---@field one_way_x? number not (0, 0): solid only for what comes from that side, as a platform is
---@field one_way_y? number in the body's frame, of any length

---Adds a body with one rectangle around its origin.
---@param fields World.add_box.Fields
---@return Body body
function World:add_box(fields) end

---@class World.add_circle.Fields
---@field radius number above 0 and at most 1000000; m
---@field x? number from -1e+12 to 1e+12; m
---@field y? number from -1e+12 to 1e+12; m
---@field angle? number rad
---@field type? string "static", "kinematic" or "dynamic"
---@field linear_velocity_x? number m/s, of the centre of mass
---@field linear_velocity_y? number m/s, of the centre of mass
---@field angular_velocity? number rad/s
---@field linear_damping? number at least 0; 1/s; c in v e^(-c t)
---@field angular_damping? number at least 0; 1/s
---@field gravity_scale? number
---@field allow_sleep? boolean
---@field awake? boolean
---@field lock_x? boolean the centre of mass stays at its x
---@field lock_y? boolean the centre of mass stays at its y
---@field lock_rotation? boolean it does not turn
---@field sleep_speed? number at least 0; m/s; may sleep when slower than this for half a second; at 0 it never does
---@field data? table becomes body.data
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field density? number at least 0; kg/m^2; a dynamic body whose shapes all have 0 has no mass: no force moves it, gravity neither, and only its velocity, if it is given one, does
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field sensor? boolean collides with nothing; `world:sensor_events()` tells what comes to overlap it
---@field seen_by_sensors? boolean
---@field one_way_x? number not (0, 0): solid only for what comes from that side, as a platform is
---@field one_way_y? number in the body's frame, of any length

---Adds a body with one disc around its origin.
---@param fields World.add_circle.Fields
---@return Body body
function World:add_circle(fields) end

---@class World.add_capsule.Fields
---@field length number above 0.005 and at most 2000000; m, between the centres of the two ends, along x
---@field radius number above 0 and at most 1000000; m
---@field x? number from -1e+12 to 1e+12; m
---@field y? number from -1e+12 to 1e+12; m
---@field angle? number rad
---@field type? string "static", "kinematic" or "dynamic"
---@field linear_velocity_x? number m/s, of the centre of mass
---@field linear_velocity_y? number m/s, of the centre of mass
---@field angular_velocity? number rad/s
---@field linear_damping? number at least 0; 1/s; c in v e^(-c t)
---@field angular_damping? number at least 0; 1/s
---@field gravity_scale? number
---@field allow_sleep? boolean
---@field awake? boolean
---@field lock_x? boolean the centre of mass stays at its x
---@field lock_y? boolean the centre of mass stays at its y
---@field lock_rotation? boolean it does not turn
---@field sleep_speed? number at least 0; m/s; may sleep when slower than this for half a second; at 0 it never does
---@field data? table becomes body.data
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field density? number at least 0; kg/m^2; a dynamic body whose shapes all have 0 has no mass: no force moves it, gravity neither, and only its velocity, if it is given one, does
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field sensor? boolean collides with nothing; `world:sensor_events()` tells what comes to overlap it
---@field seen_by_sensors? boolean
---@field one_way_x? number not (0, 0): solid only for what comes from that side, as a platform is
---@field one_way_y? number in the body's frame, of any length

---Adds a body with one capsule: all points within `radius` of a segment along its x axis.
---@param fields World.add_capsule.Fields
---@return Body body
function World:add_capsule(fields) end

---@class World.add_polygon.Fields
---@field points number[][] { {x, y}, ... }, m: 3 to 256 corners in order, either way round
---@field radius? number from 0 to 1000000; m; rounds the corners outward
---@field x? number from -1e+12 to 1e+12; m
---@field y? number from -1e+12 to 1e+12; m
---@field angle? number rad
---@field type? string "static", "kinematic" or "dynamic"
---@field linear_velocity_x? number m/s, of the centre of mass
---@field linear_velocity_y? number m/s, of the centre of mass
---@field angular_velocity? number rad/s
---@field linear_damping? number at least 0; 1/s; c in v e^(-c t)
---@field angular_damping? number at least 0; 1/s
---@field gravity_scale? number
---@field allow_sleep? boolean
---@field awake? boolean
---@field lock_x? boolean the centre of mass stays at its x
---@field lock_y? boolean the centre of mass stays at its y
---@field lock_rotation? boolean it does not turn
---@field sleep_speed? number at least 0; m/s; may sleep when slower than this for half a second; at 0 it never does
---@field data? table becomes body.data
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field density? number at least 0; kg/m^2; a dynamic body whose shapes all have 0 has no mass: no force moves it, gravity neither, and only its velocity, if it is given one, does
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field sensor? boolean collides with nothing; `world:sensor_events()` tells what comes to overlap it
---@field seen_by_sensors? boolean
---@field one_way_x? number not (0, 0): solid only for what comes from that side, as a platform is
---@field one_way_y? number in the body's frame, of any length

---Adds a body with a polygon. One with dents, or with more than eight corners, becomes several convex shapes.
---@param fields World.add_polygon.Fields
---@return Body body
function World:add_polygon(fields) end

---@class World.add_segment.Fields
---@field x1 number m; one end, in the body's frame
---@field y1 number m
---@field x2 number m; the other end
---@field y2 number m
---@field x? number from -1e+12 to 1e+12; m
---@field y? number from -1e+12 to 1e+12; m
---@field angle? number rad
---@field type? string "static", "kinematic" or "dynamic"
---@field linear_velocity_x? number m/s, of the centre of mass
---@field linear_velocity_y? number m/s, of the centre of mass
---@field angular_velocity? number rad/s
---@field linear_damping? number at least 0; 1/s; c in v e^(-c t)
---@field angular_damping? number at least 0; 1/s
---@field gravity_scale? number
---@field allow_sleep? boolean
---@field awake? boolean
---@field lock_x? boolean the centre of mass stays at its x
---@field lock_y? boolean the centre of mass stays at its y
---@field lock_rotation? boolean it does not turn
---@field sleep_speed? number at least 0; m/s; may sleep when slower than this for half a second; at 0 it never does
---@field data? table becomes body.data
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field density? number at least 0; kg/m^2; a dynamic body whose shapes all have 0 has no mass: no force moves it, gravity neither, and only its velocity, if it is given one, does
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field sensor? boolean collides with nothing; `world:sensor_events()` tells what comes to overlap it
---@field seen_by_sensors? boolean
---@field one_way_x? number not (0, 0): solid only for what comes from that side, as a platform is
---@field one_way_y? number in the body's frame, of any length

---Adds a body with one line without thickness, solid from both sides.
---@param fields World.add_segment.Fields
---@return Body body
function World:add_segment(fields) end

---@class World.add_chain.Fields
---@field points number[][] { {x, y}, ... }, m: walking along them, others are kept on the right, so ground runs from right to left
---@field closed? boolean a segment leads from the last point to the first
---@field before_x? number m; the point with which another chain goes on before the first
---@field before_y? number m
---@field after_x? number m; the same behind the last point
---@field after_y? number m
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field x? number from -1e+12 to 1e+12; m
---@field y? number from -1e+12 to 1e+12; m
---@field angle? number rad
---@field type? string "static", "kinematic" or "dynamic"
---@field linear_velocity_x? number m/s, of the centre of mass
---@field linear_velocity_y? number m/s, of the centre of mass
---@field angular_velocity? number rad/s
---@field linear_damping? number at least 0; 1/s; c in v e^(-c t)
---@field angular_damping? number at least 0; 1/s
---@field gravity_scale? number
---@field allow_sleep? boolean
---@field awake? boolean
---@field lock_x? boolean the centre of mass stays at its x
---@field lock_y? boolean the centre of mass stays at its y
---@field lock_rotation? boolean it does not turn
---@field sleep_speed? number at least 0; m/s; may sleep when slower than this for half a second; at 0 it never does
---@field data? table becomes body.data

---Adds a body with one chain, of any number of points.
---@param fields World.add_chain.Fields
---@return Body body
---@return Chain chain
function World:add_chain(fields) end

---@class World.add_distance_joint.Fields
---@field body_a Body `world:ground()` for a joint to the world
---@field body_b Body
---@field x_a? number m; the anchor on body a, in the world; absent: the body's origin
---@field y_a? number m
---@field x_b? number m; the anchor on body b
---@field y_b? number m
---@field length? number above 0.005; m; absent: the present distance
---@field frequency? number at least 0; Hz, as the bodies stand when it is set; turns the spring on; with 0 nothing but its limits acts, as in a rope
---@field damping_ratio? number at least 0; 1 is critical
---@field min_length? number at least 0; m, of the spring
---@field max_length? number at least 0; m, of the spring
---@field min_spring_force? number at most 0; N; the spring pushes with no more
---@field max_spring_force? number at least 0; N; and pulls with no more
---@field enable_spring? boolean absent: on when frequency is given
---@field collide_connected? boolean whether the two bodies collide
---@field stiffness_frequency? number above 0; Hz; softer where what is held shall give
---@field stiffness_damping_ratio? number at least 0; 1 is critical
---@field break_force? number above 0; N, the mean over a step; beyond it the joint breaks
---@field break_torque? number above 0; N m, likewise
---@field data? table becomes joint.data

---Keeps two points at a distance: rigidly, as a spring or as a rope.
---@param fields World.add_distance_joint.Fields
---@return Joint joint
function World:add_distance_joint(fields) end

---@class World.add_revolute_joint.Fields
---@field body_a Body `world:ground()` for a joint to the world
---@field body_b Body
---@field x number m; the anchor on both bodies, in the world
---@field y number m
---@field lower? number rad; with upper: turns the limit on
---@field upper? number rad; any number of turns
---@field enable_limit? boolean absent: on when lower and upper are given
---@field motor_speed? number rad/s, of b against a; turns the motor on
---@field max_motor_torque? number at least 0; N m
---@field enable_motor? boolean absent: on when motor_speed is given
---@field frequency? number above 0; Hz; turns the spring on
---@field damping_ratio? number at least 0; 1 is critical
---@field target? number rad; where the spring draws to
---@field enable_spring? boolean absent: on when frequency is given
---@field collide_connected? boolean whether the two bodies collide
---@field stiffness_frequency? number above 0; Hz; softer where what is held shall give
---@field stiffness_damping_ratio? number at least 0; 1 is critical
---@field break_force? number above 0; N, the mean over a step; beyond it the joint breaks
---@field break_torque? number above 0; N m, likewise
---@field data? table becomes joint.data

---Pins two bodies together at a point about which they turn. Angle 0 is how they stand now; it counts whole turns.
---@param fields World.add_revolute_joint.Fields
---@return Joint joint
function World:add_revolute_joint(fields) end

---@class World.add_prismatic_joint.Fields
---@field body_a Body `world:ground()` for a joint to the world
---@field body_b Body
---@field x number m; the anchor on both bodies, in the world
---@field y number m
---@field axis_angle? number rad, of the axis in the world
---@field axis_x? number the axis as a direction of any length, instead of axis_angle
---@field axis_y? number
---@field lower? number m along the axis; with upper: turns the limit on
---@field upper? number m
---@field enable_limit? boolean absent: on when lower and upper are given
---@field motor_speed? number m/s, of b against a; turns the motor on
---@field max_motor_force? number at least 0; N
---@field enable_motor? boolean absent: on when motor_speed is given
---@field frequency? number above 0; Hz; turns the spring on
---@field damping_ratio? number at least 0; 1 is critical
---@field target? number m; where the spring draws to
---@field enable_spring? boolean absent: on when frequency is given
---@field collide_connected? boolean whether the two bodies collide
---@field stiffness_frequency? number above 0; Hz; softer where what is held shall give
---@field stiffness_damping_ratio? number at least 0; 1 is critical
---@field break_force? number above 0; N, the mean over a step; beyond it the joint breaks
---@field break_torque? number above 0; N m, likewise
---@field data? table becomes joint.data

---Lets b slide along an axis of a, and not turn. Translation 0 is where they stand now; without an axis it is the world's x axis.
---@param fields World.add_prismatic_joint.Fields
---@return Joint joint
function World:add_prismatic_joint(fields) end

---@class World.add_weld_joint.Fields
---@field body_a Body `world:ground()` for a joint to the world
---@field body_b Body
---@field x number m; the anchor on both bodies, in the world
---@field y number m
---@field linear_frequency? number at least 0; Hz, of a spring that holds the place; 0 is rigid
---@field linear_damping_ratio? number at least 0; 1 is critical
---@field angular_frequency? number at least 0; Hz, of a spring that holds the angle; 0 is rigid
---@field angular_damping_ratio? number at least 0; 1 is critical
---@field collide_connected? boolean whether the two bodies collide
---@field stiffness_frequency? number above 0; Hz; softer where what is held shall give
---@field stiffness_damping_ratio? number at least 0; 1 is critical
---@field break_force? number above 0; N, the mean over a step; beyond it the joint breaks
---@field break_torque? number above 0; N m, likewise
---@field data? table becomes joint.data

---Holds b to a as they stand now: rigidly, or with springs.
---@param fields World.add_weld_joint.Fields
---@return Joint joint
function World:add_weld_joint(fields) end

---@class World.add_wheel_joint.Fields
---@field body_a Body `world:ground()` for a joint to the world
---@field body_b Body
---@field x number m; the anchor on both bodies, in the world
---@field y number m
---@field axis_angle? number rad, of the axis in the world
---@field axis_x? number the axis as a direction of any length, instead of axis_angle
---@field axis_y? number
---@field frequency? number above 0; Hz
---@field damping_ratio? number at least 0; 1 is critical
---@field target? number m; where the spring draws to
---@field enable_spring? boolean
---@field lower? number m along the axis; with upper: turns the limit on
---@field upper? number m
---@field enable_limit? boolean absent: on when lower and upper are given
---@field motor_speed? number rad/s, of b against a; turns the motor on
---@field max_motor_torque? number at least 0; N m
---@field enable_motor? boolean absent: on when motor_speed is given
---@field collide_connected? boolean whether the two bodies collide
---@field stiffness_frequency? number above 0; Hz; softer where what is held shall give
---@field stiffness_damping_ratio? number at least 0; 1 is critical
---@field break_force? number above 0; N, the mean over a step; beyond it the joint breaks
---@field break_torque? number above 0; N m, likewise
---@field data? table becomes joint.data

---Hangs a wheel b from a chassis a: its centre slides along an axis of a on a spring, and it turns freely or by a motor. Without an axis it is the world's y axis. Units of the limit: m; of the motor: rad/s.
---@param fields World.add_wheel_joint.Fields
---@return Joint joint
function World:add_wheel_joint(fields) end

---@class World.add_motor_joint.Fields
---@field body_a Body `world:ground()` for a joint to the world
---@field body_b Body
---@field x number m; the anchor on both bodies, in the world
---@field y number m
---@field target_x? number m; where b's anchor shall be, in frame a
---@field target_y? number m
---@field target_angle? number rad; how b shall stand to a
---@field linear_velocity_x? number m/s, of b's anchor in frame a, without linear_frequency
---@field linear_velocity_y? number m/s
---@field angular_velocity? number rad/s, of b against a, without angular_frequency
---@field linear_frequency? number at least 0; Hz, of the way to the target; 0: the velocity counts
---@field linear_damping_ratio? number at least 0; 1 is critical
---@field angular_frequency? number at least 0; Hz, of the turn to the target; 0: the velocity counts
---@field angular_damping_ratio? number at least 0; 1 is critical
---@field max_force? number at least 0; N
---@field max_torque? number at least 0; N m
---@field collide_connected? boolean whether the two bodies collide
---@field break_force? number above 0; N, the mean over a step; beyond it the joint breaks
---@field break_torque? number above 0; N m, likewise
---@field data? table becomes joint.data

---Draws b to a target place and angle in the frame of a, or drives it at a velocity, with a force and a torque that have caps. The target 0 is how they stand now.
---@param fields World.add_motor_joint.Fields
---@return Joint joint
function World:add_motor_joint(fields) end

---@class World.add_mouse_joint.Fields
---@field body Body what is drawn
---@field x number m; what is held now, and the target at first, in the world
---@field y number m
---@field frequency? number above 0; Hz
---@field damping_ratio? number at least 0; 1 is critical
---@field max_force? number at least 0; N; absent: 1000 for each kg of the body
---@field collide_connected? boolean whether the two bodies collide
---@field break_force? number above 0; N, the mean over a step; beyond it the joint breaks
---@field break_torque? number above 0; N m, likewise
---@field data? table becomes joint.data

---Draws a point of a body to a target in the world, which `joint:set_target(x, y)` moves: the hand of a player.
---@param fields World.add_mouse_joint.Fields
---@return Joint joint
function World:add_mouse_joint(fields) end

---@class World.add_gear_joint.Fields
---@field joint_1 Joint revolute or prismatic
---@field joint_2 Joint revolute or prismatic
---@field ratio? number coordinate 1 + ratio * coordinate 2 stays; not 0; in m or 1/m between kinds
---@field collide_connected? boolean whether the two bodies collide
---@field stiffness_frequency? number above 0; Hz; softer where what is held shall give
---@field stiffness_damping_ratio? number at least 0; 1 is critical
---@field break_force? number above 0; N, the mean over a step; beyond it the joint breaks
---@field break_torque? number above 0; N m, likewise
---@field data? table becomes joint.data

---Ties the coordinates of two joints: angles (rad) of revolute ones, translations (m) of prismatic ones. It goes with either joint.
---@param fields World.add_gear_joint.Fields
---@return Joint joint
function World:add_gear_joint(fields) end

---@class World.add_pulley_joint.Fields
---@field body_a Body `world:ground()` for a joint to the world
---@field body_b Body
---@field x_a? number m; the anchor on body a, in the world; absent: the body's origin
---@field y_a? number m
---@field x_b? number m; the anchor on body b
---@field y_b? number m
---@field wheel_x_a number m; a's wheel, in the world
---@field wheel_y_a number m
---@field wheel_x_b number m; b's wheel
---@field wheel_y_b number m
---@field ratio? number above 0; of a block and tackle on the side of b
---@field length? number at least 0; m, of a's side + ratio * b's; absent: as it is now
---@field collide_connected? boolean whether the two bodies collide
---@field stiffness_frequency? number above 0; Hz; softer where what is held shall give
---@field stiffness_damping_ratio? number at least 0; 1 is critical
---@field break_force? number above 0; N, the mean over a step; beyond it the joint breaks
---@field break_torque? number above 0; N m, likewise
---@field data? table becomes joint.data

---A rope from a over two fixed wheels to b. It pulls and never pushes.
---@param fields World.add_pulley_joint.Fields
---@return Joint joint
function World:add_pulley_joint(fields) end

---@class World.add_friction_joint.Fields
---@field body_a Body `world:ground()` for a joint to the world
---@field body_b Body
---@field x number m; the anchor on both bodies, in the world
---@field y number m
---@field max_force? number at least 0; N
---@field max_torque? number at least 0; N m
---@field collide_connected? boolean whether the two bodies collide
---@field data? table becomes joint.data

---Friction between b and a, as of things on a table seen from above.
---@param fields World.add_friction_joint.Fields
---@return Joint joint
function World:add_friction_joint(fields) end

---@class World.add_filter_joint.Fields
---@field body_a Body `world:ground()` for a joint to the world
---@field body_b Body
---@field data? table becomes joint.data

---Keeps two bodies from colliding.
---@param fields World.add_filter_joint.Fields
---@return Joint joint
function World:add_filter_joint(fields) end

---Adds many bodies: a list of tables, each with `shape` ("box", "circle", "capsule", "polygon" or "segment"; absent: none) and the fields that `add_box` and its like take. Gives the list of the bodies; with an error, which names the place in the list, nothing is added.
---@param descriptions table
---@return table bodies
function World:add_bodies(descriptions) end

---A new list of all joints.
---@return table joints
function World:joints() end

---A new list of the pairs of shapes that touch now: tables with `body_a`, `body_b`, `shape_a`, `shape_b`, `nx, ny` (unit, from a to b), `friction_impulse` (N s) and `points`, a list of tables with `x, y` (m), `separation` (m, negative where they overlap) and `impulse` (N s). Made for tools; in each step, `events` costs less.
---@return table contacts
function World:contacts() end

---A new list of the groups of bodies that move and fall asleep together: tables with `bodies` and `awake`.
---@return table islands
function World:islands() end

---A new list of the boxes of the broad phase: tables with `shape`, and `x1, y1`, `x2, y2` (m).
---@return table boxes
function World:boxes() end

---Removes all bodies of a list; with an error, which names the place in the list, none.
---@param bodies table
function World:destroy_bodies(bodies) end

---A static body without shapes at the origin, for joints to the world. Made when it is first asked for.
---@return Body body
function World:ground() end

---Iterates over the joints that the last step loaded beyond their strength: `for joint, a, b, x, y, fx, fy, torque, kind in world:joint_breaks() do`. The joint is gone, and its value is still the one that `add_..._joint` returned, with its `data`; `a` and `b` are its bodies, `x, y` the anchor on b (m), `fx, fy` (N) and `torque` (N m) what it did to b, as the mean over the step, `kind` what `joint:kind()` says.
---@return fun(): Joint, Body, Body, number, number, number, number, number, string iterator
function World:joint_breaks() end

---Iterates over the breakable bodies on which something pressed harder in the last step than they withstand: `for body, other, impulse, x, y, nx, ny, speed, pieces in world:breaks() do`. `other` is what pressed, `impulse` (N s) how hard, `x, y` where, `nx, ny` the unit normal into the body, `speed` (m/s) how fast they met, `pieces` a list of the bodies into which the step broke it; it is empty when it was not automatic or too small to break.
---@return fun(): Body, Body, number, number, number, number, number, number, table iterator
function World:breaks() end

---What lies across a cut, in the order of the way: tables with `body`, `x1, y1` and `x2, y2` where the way enters and leaves it, and `pieces`, how many bodies `body:cut` would make of it. Changes nothing.
---@param x1 number [m]
---@param y1 number [m]
---@param x2 number [m]
---@param y2 number [m]
---@param filter integer|function|table?
---@param ignored Body?
---@return table hits
function World:cuts_along(x1, y1, x2, y2, filter, ignored) end

---Iterates over the events of the last step: `for kind, a, b, impulse, x, y, nx, ny, speed in world:events("hit") do`. `kind` is "begin", "end" or "hit"; without an argument all come, begins first, then hits, then ends. `a` and `b` are the bodies, `x, y` the place, `nx, ny` the unit normal from a to b, `impulse` (N s) what the contact exchanged in the step and `speed` (m/s) how fast they met; what an event does not have is 0. A body destroyed since the step is still given: `is_valid()` tells, and its `data` can be read. With `with_shapes` the two shapes come last: `for kind, a, b, impulse, x, y, nx, ny, speed, shape_a, shape_b in world:events("hit", true) do`. Anything may be done in the loop; stepping the world ends it.
---@param kind string?
---@param with_shapes boolean?
---@return fun(): string, Body, Body, number, number, number, number, number, number, Shape?, Shape? iterator
function World:events(kind, with_shapes) end

---Iterates over what came to overlap sensors in the last step, and what ceased to: `for kind, sensor, visitor, sensor_shape, visitor_shape in world:sensor_events() do`. `kind` is "begin" or "end"; `sensor` and `visitor` are the bodies. What passes through a sensor within one step begins with it and ends with the next.
---@return fun(): string, Body, Body, Shape, Shape iterator
function World:sensor_events() end

---A new list of all bodies, in a fixed order.
---@return table bodies
function World:bodies() end

---Writes the places of all bodies into a list in one pass, without garbage.
---@param transforms Transforms
---@return integer count
function World:read_transforms(transforms) end

---A new list of the bodies whose motion became infinite in the last step, or led farther than 1e12 m from the origin: each was put back to where it was and stopped. Empty unless forces beyond all measure act.
---@return table bodies
function World:quarantined() end

---A body with a shape that contains the point, and that shape; of several the newest shape's; nil when there is none.
---@param x number [m]
---@param y number [m]
---@param filter integer|function|table?
---@param ignored Body?
---@return Body? body
---@return Shape? shape
function World:body_at(x, y, filter, ignored) end

---The first shape that the ray meets from outside: its body, the point, the normal out of the shape, the share of the ray's length, and the shape; nil when it meets none. A shape in which the ray begins is not met.
---@param x1 number [m]
---@param y1 number [m]
---@param x2 number [m]
---@param y2 number [m]
---@param filter integer|function|table?
---@param ignored Body?
---@return Body? body
---@return number x [m]
---@return number y [m]
---@return number nx
---@return number ny
---@return number fraction
---@return Shape shape
function World:cast_ray(x1, y1, x2, y2, filter, ignored) end

---All shapes that the ray meets, in its order: tables with body, shape, x, y, nx, ny, fraction.
---@param x1 number [m]
---@param y1 number [m]
---@param x2 number [m]
---@param y2 number [m]
---@param filter integer|function|table?
---@param ignored Body?
---@return table hits
function World:cast_ray_all(x1, y1, x2, y2, filter, ignored) end

---The first shape met by one that moves without turning: `{ shape = "circle", radius = 1, x = 0, y = 2 }`, with the fields of `world:add_circle` and its like, and `x`, `y`, `angle` where it starts. What it overlaps there is met at fraction 0. nil when it meets none.
---@param shape table
---@param dx number [m]
---@param dy number [m]
---@param filter integer|function|table?
---@param ignored Body?
---@return Body? body
---@return number x [m]
---@return number y [m]
---@return number nx
---@return number ny
---@return number fraction
---@return number overlap [m]
---@return Shape shape
function World:cast_shape(shape, dx, dy, filter, ignored) end

---All shapes met: tables with body, shape, x, y, nx, ny, fraction, overlap.
---@param shape table
---@param dx number [m]
---@param dy number [m]
---@param filter integer|function|table?
---@param ignored Body?
---@return table hits
function World:cast_shape_all(shape, dx, dy, filter, ignored) end

---A new list of the shapes that a shape, described as for cast_shape, touches or overlaps.
---@param shape table
---@param filter integer|function|table?
---@param ignored Body?
---@return table shapes
function World:shapes_overlapping(shape, filter, ignored) end

---A new list of the shapes that touch or overlap a box between two corners.
---@param x1 number [m]
---@param y1 number [m]
---@param x2 number [m]
---@param y2 number [m]
---@param filter integer|function|table?
---@param ignored Body?
---@return table shapes
function World:shapes_in_box(x1, y1, x2, y2, filter, ignored) end

---The nearest surface within a radius; inside shapes the distance is negative. nil when there is none.
---@param x number [m]
---@param y number [m]
---@param radius number [m] at least 0
---@param filter integer|function|table?
---@param ignored Body?
---@return Body? body
---@return number x [m]
---@return number y [m]
---@return number nx
---@return number ny
---@return number distance [m]
---@return Shape shape
function World:closest_point(x, y, radius, filter, ignored) end

---The nearest point of each shape within a radius: tables with body, shape, x, y, nx, ny, distance.
---@param x number [m]
---@param y number [m]
---@param radius number [m] at least 0
---@param filter integer|function|table?
---@param ignored Body?
---@return table points
function World:closest_points(x, y, radius, filter, ignored) end

---What limits a shape, described as for cast_shape: a line for each shape within reach, as tables with body, shape, x, y, nx, ny, separation, dynamic, and, where edges meet at a corner, nx_before, ny_before, nx_after, ny_after. For characters of your own; see cairn.physics.solve_planes and new_mover.
---@param shape table
---@param reach number [m] at least 0
---@param filter integer|function|table?
---@param ignored Body?
---@return table planes
function World:collision_planes(shape, reach, filter, ignored) end

---@class World.explode.Fields
---@field x? number m
---@field y? number m
---@field radius? number at least 0; m; full strength up to here
---@field falloff? number at least 0; m; from there on it fades to nothing over this distance
---@field impulse? number N s per metre of outline that faces the point; negative: inward
---@field shelter? integer bit set: shapes of these categories keep it from what lies behind them
---@field mask? integer bit set: the categories that are met
---@field categories? integer bit set: only what would collide with one of these is met
---@field accepts? function gets a body and a shape, says true or false: whether it is met
---@field ignored? Body is not met

---Pushes the dynamic bodies around a point, as a pressure on the outline that faces it.
---@param fields World.explode.Fields
function World:explode(fields) end

---@class World.apply_wind.Fields
---@field velocity_x? number m/s, of the air; (0, 0) slows bodies down
---@field velocity_y? number m/s
---@field density? number at least 0; kg/m^2, of the air
---@field drag? number at least 0; 1 suits most shapes
---@field lift? number at least 0; 1 suits flat plates
---@field mask? integer bit set: the categories that are met
---@field categories? integer bit set: only what would collide with one of these is met
---@field accepts? function gets a body and a shape, says true or false: whether it is met
---@field ignored? Body is not met

---Of moving air on all dynamic bodies that are awake, during the next step, which takes dt.
---@param fields World.apply_wind.Fields
---@param dt number [s] above 0 and at most 1
function World:apply_wind(fields, dt) end

---@class World.set_material_rule.Fields
---@field friction? string how the two values mix
---@field fixed_friction? number at least 0; with "fixed"
---@field restitution? string how the two values mix
---@field fixed_restitution? number from 0 to 1; with "fixed"

---How materials of two kinds (`material_kind` of shapes) mix.
---@param kind_a integer from 0 to 63
---@param kind_b integer from 0 to 63
---@param fields World.set_material_rule.Fields
function World:set_material_rule(kind_a, kind_b, fields) end

---A new table with the fields that `set_material_rule` takes.
---@param kind_a integer from 0 to 63
---@param kind_b integer from 0 to 63
---@return table rule
function World:material_rule(kind_a, kind_b) end

---Asks a function which pairs of shapes collide, besides their categories, masks and groups: `world:set_pair_filter(function(a, b, shape_a, shape_b) return a.data.team ~= b.data.team end)`. It is called once for each pair whose boxes come together, in the step in which they do and in an order that depends on the game alone; its answer, true or false, holds until the two part. It may read bodies and shapes and their `data`, and must not change anything. nil ends the asking; pairs that are near each other keep their answers. An error in it is raised by `step`, which is done then; the rest of that step's pairs collide. Snapshots do not hold the filter.
---@param filter function?
function World:set_pair_filter(filter) end

---@return number x [m/s^2]
---@return number y [m/s^2]
function World:gravity() end

---Wakes every body.
---@param x number [m/s^2]
---@param y number [m/s^2]
function World:set_gravity(x, y) end

---@return integer count
function World:body_count() end

---How many dynamic and kinematic bodies are awake.
---@return integer count
function World:awake_count() end

---@return integer count
function World:joint_count() end

---How many pairs of shapes touch.
---@return integer count
function World:contact_count() end

---Steps since the world was made.
---@return integer count
function World:step_count() end

---16 hexadecimal digits over all that decides the future of the bodies: equal hashes, equal worlds.
---@return string hash
function World:state_hash() end

---How the world is doing now: `max_penetration` and `max_joint_error` (m), `max_joint_angle_error` (rad), how fast such errors grow, `residual` (m/s) and `angular_residual` (rad/s), `kinetic_energy`, `potential_energy` and `elastic_energy` (J), `momentum_x`, `momentum_y` (kg m/s) and `angular_momentum` about the origin (kg m^2/s); counts: `bodies`, `awake_bodies`, `shapes`, `joints`, `awake_joints`, `contacts`, `touching`, `awake_touching`, `islands`; and `stages`, the milliseconds of the stages of the last step that was measured, which are to be shown and differ from run to run. Costs about as much as the contacts of a step, and nothing when it is not called.
---@return table report
function World:report() end

---Whether steps measure their stages for `world:report()`; off at first.
---@param enabled boolean
function World:set_profiling(enabled) end

---All that decides the future of the world: a table with `bytes`, a string to save or to send, the same on every machine, and `bodies`, the list of the bodies that there are now. Data of bodies and other values of the script are not part of it.
---@return table snapshot
function World:snapshot() end

---Puts the world into the state of a snapshot, its own or another world's, as if all since then had not happened; from there it goes on exactly as it did. Takes what `world:snapshot()` gave, or its `bytes` alone. Bodies are the same values as before and keep their `data`. One that was destroyed since comes back; with the bytes alone it is a new value with an empty table. One that was made since is destroyed. Bytes that are damaged or of another version are an error, and nothing changes.
---@param snapshot any
function World:restore(snapshot) end

---Frees the world; its bodies become invalid.
function World:destroy() end

---Whether the world was not destroyed.
---@return boolean valid
function World:is_valid() end

---@class Body
---@field data table
local Body = {}

---"static", "kinematic" or "dynamic".
---@return string type
function Body:type() end

---The place of the body's origin.
---@return number x [m]
---@return number y [m]
function Body:position() end

---@param x number [m]
---@param y number [m]
function Body:set_position(x, y) end

---In (-pi, pi].
---@return number angle [rad]
function Body:angle() end

---@param angle number [rad]
function Body:set_angle(angle) end

---Position and angle in one call.
---@return number x [m]
---@return number y [m]
---@return number angle [rad]
function Body:transform() end

---@param x number [m]
---@param y number [m]
---@param angle number [rad]
function Body:set_transform(x, y, angle) end

---Where to draw the body: between the last two steps, alpha 0 is before the last step and 1 after it.
---@param alpha number?
---@return number x [m]
---@return number y [m]
---@return number angle [rad]
function Body:interpolated_transform(alpha) end

---The centre of mass.
---@return number x [m]
---@return number y [m]
function Body:world_center() end

---From the body's frame to the world.
---@param x number [m]
---@param y number [m]
---@return number x [m]
---@return number y [m]
function Body:to_world(x, y) end

---From the world to the body's frame.
---@param x number [m]
---@param y number [m]
---@return number x [m]
---@return number y [m]
function Body:to_local(x, y) end

---Of the centre of mass.
---@return number x [m/s]
---@return number y [m/s]
function Body:linear_velocity() end

---@param x number [m/s]
---@param y number [m/s]
function Body:set_linear_velocity(x, y) end

---@return number velocity [rad/s]
function Body:angular_velocity() end

---@param velocity number [rad/s]
function Body:set_angular_velocity(velocity) end

---Of the point of the body that is at a place in the world.
---@param x number [m]
---@param y number [m]
---@return number x [m/s]
---@return number y [m/s]
function Body:velocity_at(x, y) end

---At a place in the world; acts during the next step.
---@param fx number [N]
---@param fy number [N]
---@param x number [m]
---@param y number [m]
function Body:apply_force(fx, fy, x, y) end

---Acts during the next step.
---@param fx number [N]
---@param fy number [N]
function Body:apply_force_to_center(fx, fy) end

---Acts during the next step.
---@param torque number [N m]
function Body:apply_torque(torque) end

---At a place in the world; changes the velocity at once.
---@param ix number [N s]
---@param iy number [N s]
---@param x number [m]
---@param y number [m]
function Body:apply_impulse(ix, iy, x, y) end

---Changes the velocity at once.
---@param ix number [N s]
---@param iy number [N s]
function Body:apply_impulse_to_center(ix, iy) end

---Changes the angular velocity at once.
---@param impulse number [N m s]
function Body:apply_angular_impulse(impulse) end

---@class Body.apply_wind.Fields
---@field velocity_x? number m/s, of the air; (0, 0) slows bodies down
---@field velocity_y? number m/s
---@field density? number at least 0; kg/m^2, of the air
---@field drag? number at least 0; 1 suits most shapes
---@field lift? number at least 0; 1 suits flat plates
---@field mask? integer bit set: the categories that are met
---@field categories? integer bit set: only what would collide with one of these is met
---@field accepts? function gets a body and a shape, says true or false: whether it is met
---@field ignored? Body is not met

---Of moving air, or water, during the next step, which takes dt; wakes the body.
---@param fields Body.apply_wind.Fields
---@param dt number [s] above 0 and at most 1
function Body:apply_wind(fields, dt) end

---0 unless dynamic.
---@return number mass [kg]
function Body:mass() end

---About the centre of mass; 0 unless dynamic.
---@return number inertia [kg m^2]
function Body:inertia() end

---The centre of mass in the body's frame; (0, 0) unless dynamic.
---@return number x [m]
---@return number y [m]
function Body:local_center() end

---@return number damping [1/s]
function Body:linear_damping() end

---c in v e^(-c t).
---@param damping number [1/s] at least 0
function Body:set_linear_damping(damping) end

---@return number damping [1/s]
function Body:angular_damping() end

---@param damping number [1/s] at least 0
function Body:set_angular_damping(damping) end

---@return number scale
function Body:gravity_scale() end

---0 lets the body float, 1 is the world's gravity.
---@param scale number
function Body:set_gravity_scale(scale) end

---@return boolean awake
function Body:is_awake() end

---Putting a body to sleep puts to sleep all that it touches or is jointed to. What a moving kinematic body holds or touches wakes again.
---@param awake boolean
function Body:set_awake(awake) end

---@return boolean allows
function Body:allows_sleep() end

---@param allow boolean
function Body:set_allow_sleep(allow) end

---Which of its motions are locked.
---@return boolean x
---@return boolean y
---@return boolean rotation
function Body:locks() end

---Its centre of mass stays at its x or y, or it does not turn, whatever acts on it.
---@param x boolean
---@param y boolean
---@param rotation boolean
function Body:set_locks(x, y, rotation) end

---@return number speed [m/s]
function Body:sleep_speed() end

---Slower than this it may sleep; at 0 never.
---@param speed number [m/s] at least 0
function Body:set_sleep_speed(speed) end

---@class Body.add_box.Fields
---@field width number above 0 and at most 2000000; m
---@field height number above 0 and at most 2000000; m
---@field radius? number from 0 to 1000000; m; rounds the corners outward
---@field x? number from -1e+12 to 1e+12; m
---@field y? number from -1e+12 to 1e+12; m
---@field angle? number rad
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field density? number at least 0; kg/m^2; a dynamic body whose shapes all have 0 has no mass: no force moves it, gravity neither, and only its velocity, if it is given one, does
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field sensor? boolean collides with nothing; `world:sensor_events()` tells what comes to overlap it
---@field seen_by_sensors? boolean
---@field one_way_x? number not (0, 0): solid only for what comes from that side, as a platform is
---@field one_way_y? number in the body's frame, of any length
---@field data? table becomes shape.data

---Adds a rectangle, placed in the body's frame.
---@param fields Body.add_box.Fields
---@return Shape shape
function Body:add_box(fields) end

---@class Body.add_circle.Fields
---@field radius number above 0 and at most 1000000; m
---@field x? number from -1e+12 to 1e+12; m
---@field y? number from -1e+12 to 1e+12; m
---@field angle? number rad
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field density? number at least 0; kg/m^2; a dynamic body whose shapes all have 0 has no mass: no force moves it, gravity neither, and only its velocity, if it is given one, does
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field sensor? boolean collides with nothing; `world:sensor_events()` tells what comes to overlap it
---@field seen_by_sensors? boolean
---@field one_way_x? number not (0, 0): solid only for what comes from that side, as a platform is
---@field one_way_y? number in the body's frame, of any length
---@field data? table becomes shape.data

---Adds a disc.
---@param fields Body.add_circle.Fields
---@return Shape shape
function Body:add_circle(fields) end

---@class Body.add_capsule.Fields
---@field length number above 0.005 and at most 2000000; m, between the centres of the two ends, along x
---@field radius number above 0 and at most 1000000; m
---@field x? number from -1e+12 to 1e+12; m
---@field y? number from -1e+12 to 1e+12; m
---@field angle? number rad
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field density? number at least 0; kg/m^2; a dynamic body whose shapes all have 0 has no mass: no force moves it, gravity neither, and only its velocity, if it is given one, does
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field sensor? boolean collides with nothing; `world:sensor_events()` tells what comes to overlap it
---@field seen_by_sensors? boolean
---@field one_way_x? number not (0, 0): solid only for what comes from that side, as a platform is
---@field one_way_y? number in the body's frame, of any length
---@field data? table becomes shape.data

---Adds a capsule.
---@param fields Body.add_capsule.Fields
---@return Shape shape
function Body:add_capsule(fields) end

---@class Body.add_polygon.Fields
---@field points number[][] { {x, y}, ... }, m: 3 to 256 corners in order, either way round
---@field radius? number from 0 to 1000000; m; rounds the corners outward
---@field x? number from -1e+12 to 1e+12; m
---@field y? number from -1e+12 to 1e+12; m
---@field angle? number rad
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field density? number at least 0; kg/m^2; a dynamic body whose shapes all have 0 has no mass: no force moves it, gravity neither, and only its velocity, if it is given one, does
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field sensor? boolean collides with nothing; `world:sensor_events()` tells what comes to overlap it
---@field seen_by_sensors? boolean
---@field one_way_x? number not (0, 0): solid only for what comes from that side, as a platform is
---@field one_way_y? number in the body's frame, of any length
---@field data? table becomes shape.data

---Adds a polygon. One with dents, or with more than eight corners, becomes several convex shapes, which are all returned.
---@param fields Body.add_polygon.Fields
---@return Shape shape
function Body:add_polygon(fields) end

---@class Body.add_segment.Fields
---@field x1 number m; one end, in the body's frame
---@field y1 number m
---@field x2 number m; the other end
---@field y2 number m
---@field x? number from -1e+12 to 1e+12; m
---@field y? number from -1e+12 to 1e+12; m
---@field angle? number rad
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field density? number at least 0; kg/m^2; a dynamic body whose shapes all have 0 has no mass: no force moves it, gravity neither, and only its velocity, if it is given one, does
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field sensor? boolean collides with nothing; `world:sensor_events()` tells what comes to overlap it
---@field seen_by_sensors? boolean
---@field one_way_x? number not (0, 0): solid only for what comes from that side, as a platform is
---@field one_way_y? number in the body's frame, of any length
---@field data? table becomes shape.data

---Adds a line without thickness or mass, solid from both sides.
---@param fields Body.add_segment.Fields
---@return Shape shape
function Body:add_segment(fields) end

---@class Body.add_chain.Fields
---@field points number[][] { {x, y}, ... }, m: walking along them, others are kept on the right, so ground runs from right to left
---@field closed? boolean a segment leads from the last point to the first
---@field before_x? number m; the point with which another chain goes on before the first
---@field before_y? number m
---@field after_x? number m; the same behind the last point
---@field after_y? number m
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events

---Adds an outline of many segments, solid from one side, without mass.
---@param fields Body.add_chain.Fields
---@return Chain chain
function Body:add_chain(fields) end

---A new list, in order of creation.
---@return table shapes
function Body:shapes() end

---A new list.
---@return table joints
function Body:joints() end

---A new list of what touches it now, as `world:contacts()` tells it.
---@return table contacts
function Body:contacts() end

---@return World world
function Body:world() end

---Cuts the body along a segment, from side to side: a list of the new bodies, at least two, or an empty one when it still hangs together; then nothing has changed. Pieces move on as the material was moving, and have copies of the body's data; the body itself is gone. A copy is a new table with the same values: tables within it are shared by all pieces.
---@param x1 number [m]
---@param y1 number [m]
---@param x2 number [m]
---@param y2 number [m]
---@return table pieces
function Body:cut(x1, y1, x2, y2) end

---@class Body.fracture.Fields
---@field x? number m, of the impact; absent: the centre of mass
---@field y? number m
---@field pattern? string "uniform", pieces of about one size, or "radial", shards about the impact
---@field pieces? integer from 2 to 256; about how many
---@field seed? integer the same seed, body and impact give the same pieces
---@field min_width? number at least 0.01; m, of a piece
---@field radius? number above 0; m; what is farther from the impact stays whole
---@field grain_x? number pieces are longer along the grain, 1 to 16 times
---@field grain_y? number
---@field release? boolean pieces of a static or kinematic body become dynamic

---Breaks the body about an impact: a list of the new bodies, or an empty one when it is too small for two; then nothing has changed. What is not given is as `set_breakable` said, if it did.
---@param fields Body.fracture.Fields
---@return table pieces
function Body:fracture(fields) end

---@class Body.set_breakable.Fields
---@field strength? number above 0; N s, the impulse of a contact in a step that it withstands
---@field generations? integer from 1 to 16; how often; pieces break one time less often
---@field automatic? boolean the step breaks it; otherwise the script does, when it reads world:breaks()
---@field gives_back? boolean what broke it keeps the momentum that it did not withstand
---@field pattern? string "uniform", pieces of about one size, or "radial", shards about the impact
---@field pieces? integer from 2 to 256; about how many
---@field seed? integer the same seed, body and impact give the same pieces
---@field min_width? number at least 0.01; m, of a piece
---@field radius? number above 0; m; what is farther from the impact stays whole
---@field grain_x? number pieces are longer along the grain, 1 to 16 times
---@field grain_y? number
---@field release? boolean pieces of a static or kinematic body become dynamic

---From now on the body breaks when a contact presses harder on it in a step than it withstands; `world:breaks()` tells of it.
---@param fields Body.set_breakable.Fields
function Body:set_breakable(fields) end

---The body withstands everything again.
function Body:clear_breakable() end

---@return boolean breakable
function Body:is_breakable() end

---A new table with the fields that `set_breakable` takes; nil unless it is.
---@return table? fields
function Body:breakable() end

---Removes the body with its shapes and joints. What rested on it wakes.
function Body:destroy() end

---Whether the body was not destroyed.
---@return boolean valid
function Body:is_valid() end

---@class Shape
---@field data table
local Shape = {}

---@return Body body
function Shape:body() end

---nil unless it is a segment of a chain.
---@return Chain? chain
function Shape:chain() end

---"circle", "capsule", "polygon" (boxes are polygons), "segment" or "chain_segment".
---@return string kind
function Shape:kind() end

---x1, y1, x2, y2, ...: the centre of a circle, the two ends of a capsule, or the corners of a polygon anticlockwise, in the body's frame.
---@return number x1 [m]
function Shape:points() end

---Of the circle or capsule; of a polygon how far its corners are rounded.
---@return number radius [m]
function Shape:radius() end

---@return number density [kg/m^2]
function Shape:density() end

---The mass of the body follows, and the body wakes.
---@param density number [kg/m^2] at least 0
function Shape:set_density(density) end

---@return number friction
function Shape:friction() end

---@param friction number at least 0
function Shape:set_friction(friction) end

---@return number restitution
function Shape:restitution() end

---@param restitution number from 0 to 1
function Shape:set_restitution(restitution) end

---@return integer categories
---@return integer mask
---@return integer group
function Shape:filter() end

---Ends touching that the new filter forbids.
---@param categories integer
---@param mask integer
---@param group integer from -2147483648 to 2147483647
function Shape:set_filter(categories, mask, group) end

---A new table with the fields that `set_material` takes.
---@return table material
function Shape:material() end

---@class Shape.set_material.Fields
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by

---What is not given is as by default.
---@param fields Shape.set_material.Fields
function Shape:set_material(fields) end

---In the body's frame; (0, 0): solid from all sides.
---@return number x
---@return number y
function Shape:one_way() end

---Solid only for what comes from that side; (0, 0): from all sides.
---@param x number
---@param y number
function Shape:set_one_way(x, y) end

---@return boolean sensor
function Shape:is_sensor() end

---Of a sensor: a new list of what overlapped it at the end of the last step, or passed through it within that step.
---@return table shapes
function Shape:overlaps() end

---@return boolean seen
function Shape:is_seen_by_sensors() end

---@param seen boolean
function Shape:set_seen_by_sensors(seen) end

---Removes the shape from its body.
function Shape:destroy() end

---Whether the shape was not destroyed.
---@return boolean valid
function Shape:is_valid() end

---@class Chain
---@field data table
local Chain = {}

---@return Body body
function Chain:body() end

---@return boolean closed
function Chain:is_closed() end

---@return integer count
function Chain:point_count() end

---In the body's frame; points count from 1.
---@param index integer
---@return number x [m]
---@return number y [m]
function Chain:point(index) end

---Moves a point; what lies on it wakes.
---@param index integer
---@param x number [m]
---@param y number [m]
function Chain:set_point(index, x, y) end

---Puts a list { {x, y}, ... } before a point, or after all when `index` is their number + 1: endless ground.
---@param index integer
---@param points table
function Chain:insert_points(index, points) end

---@param first integer
---@param count integer
function Chain:remove_points(first, count) end

---With which points other chains go on: nothing then feels the join.
---@param before_x number? [m]
---@param before_y number? [m]
---@param after_x number? [m]
---@param after_y number? [m]
function Chain:set_ends(before_x, before_y, after_x, after_y) end

---The shape that leads from a point to the next one.
---@param index integer
---@return Shape shape
function Chain:segment(index) end

---Which segment a shape is; nil for other shapes.
---@param shape Shape
---@return integer? index
function Chain:index_of(shape) end

---@param segment integer
---@return number friction
---@return number restitution
---@return number rolling_resistance
---@return number surface_speed [m/s]
---@return integer material_kind
function Chain:material(segment) end

---@class Chain.set_material.Fields
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by

---What is not given is as by default.
---@param segment integer
---@param fields Chain.set_material.Fields
function Chain:set_material(segment, fields) end

---Removes the chain from its body.
function Chain:destroy() end

---Whether the chain was not destroyed.
---@return boolean valid
function Chain:is_valid() end

---@class Joint
---@field data table
local Joint = {}

---"distance", "revolute", "prismatic", "weld", "wheel", "motor", "mouse", "gear", "pulley", "friction" or "filter". Of a joint that broke, too, until the next step.
---@return string kind
function Joint:kind() end

---@return Body body
function Joint:body_a() end

---@return Body body
function Joint:body_b() end

---In the world; of a mouse joint the target.
---@return number x [m]
---@return number y [m]
function Joint:anchor_a() end

---In the world.
---@return number x [m]
---@return number y [m]
function Joint:anchor_b() end

---What the joint did to body b, as the mean over the last step.
---@return number x [N]
---@return number y [N]
function Joint:reaction_force() end

---What the joint did to body b, as the mean over the last step.
---@return number torque [N m]
function Joint:reaction_torque() end

---Of b relative to a, with whole turns; 0 for kinds that have none.
---@return number angle [rad]
function Joint:angle() end

---Of b along the axis of a prismatic or wheel joint; 0 for others.
---@return number translation [m]
function Joint:translation() end

---The distance between the two anchors.
---@return number length [m]
function Joint:length() end

---The present value of a field that `add_..._joint` of this kind takes besides bodies and places, or of a frame: `local_x_a`, `local_y_a`, `local_x_b`, `local_y_b` (m), `local_angle_a` and `local_angle_b` (rad), the anchors and axes in the coordinates of the bodies.
---@param name string
---@return number|boolean value
function Joint:parameter(name) end

---A new table of them all, by name.
---@return table values
function Joint:parameters() end

---Changes any of the parameters, by the names of `parameter`, and wakes the bodies: `joint:change{ motor_speed = 3, upper = 1 }`. What is not named stays.
---@param fields table
function Joint:change(fields) end

---Of a revolute or wheel joint in rad/s and N m, of a prismatic one in m/s and N.
---@param enabled boolean
---@param speed number
---@param max_effort number at least 0
function Joint:set_motor(enabled, speed, max_effort) end

---Of a revolute joint in rad, of a prismatic or wheel joint in m.
---@param enabled boolean
---@param lower number
---@param upper number
function Joint:set_limits(enabled, lower, upper) end

---Of a distance, revolute, prismatic or wheel joint.
---@param enabled boolean
---@param frequency number [Hz] at least 0
---@param damping_ratio number at least 0
function Joint:set_spring(enabled, frequency, damping_ratio) end

---Where the spring draws to: of a revolute joint in rad, of a prismatic or wheel joint in m. Of a mouse joint x, y in the world.
---@param target number
---@param y number?
function Joint:set_target(target, y) end

---Of a distance joint: its rest length. Of a pulley joint: its rope's.
---@param length number [m] above 0
function Joint:set_length(length) end

function Joint:destroy() end

---Whether the joint was not destroyed; it goes with either of its bodies.
---@return boolean valid
function Joint:is_valid() end

---@class Mover
local Mover = {}

---Goes on for a step at a velocity, slides along what it meets, walks over steps and down slopes, and pushes dynamic bodies. What `filter` and `ignored` hide, as in queries of worlds, is walked through.
---@param world World
---@param vx number [m/s]
---@param vy number [m/s]
---@param dt number [s] above 0 and at most 1
---@param filter integer|function|table?
---@param ignored Body?
function Mover:move(world, vx, vy, dt, filter, ignored) end

---Somewhere else at once, standing on nothing.
---@param x number [m]
---@param y number [m]
function Mover:teleport(x, y) end

---Of its feet.
---@return number x [m]
---@return number y [m]
function Mover:position() end

---What is left of the wanted velocity; on the ground relative to it.
---@return number x [m/s]
---@return number y [m/s]
function Mover:velocity() end

---Whether it stands on something that is not too steep.
---@return boolean grounded
function Mover:is_grounded() end

---(0, 0) in the air.
---@return number x
---@return number y
function Mover:ground_normal() end

---What it stands on; nil in the air.
---@param world World
---@return Body? body
function Mover:ground_body(world) end

---Likewise, which shape of it.
---@param world World
---@return Shape? shape
function Mover:ground_shape(world) end

---@class Transforms
local Transforms = {}

---How many places it holds.
---@return integer count
function Transforms:count() end

---Indices count from 1, in the order of `world:bodies()`.
---@param index integer
---@return number x [m]
---@return number y [m]
function Transforms:position(index) end

---@param index integer
---@return number x [m]
---@return number y [m]
---@return number angle [rad]
function Transforms:transform(index) end

---nil when it was destroyed long since.
---@param index integer
---@return Body? body
function Transforms:body(index) end

---@class Recording
local Recording = {}

---Appends the state of a world as it is now: call it after each step, and once before the first.
---@param world World
function Recording:record(world) end

---How many states there are.
---@return integer count
function Recording:size() end

---In memory, and about as much in a file.
---@return integer bytes
function Recording:byte_count() end

---Puts a world into a state, from 1 to `size()`, bit for bit. Bodies that are there before and after keep their values and `data`; one that comes back is a new value with an empty table.
---@param world World
---@param index integer
function Recording:seek(world, index) end

---Forgets the states from `index` on: to record another future from there.
---@param index integer
function Recording:cut(index) end

---All of it as a string with a version and a checksum, for `cairn.files.write`.
---@return string bytes
function Recording:save() end

---Takes what `save` gave, here or on another machine, instead of what it holds. Bytes that are damaged or of another version are an error, and nothing changes.
---@param bytes string
function Recording:load(bytes) end

cairn.prefab = {}

---@class cairn.prefab.chain.Fields
---@field x? number m
---@field y? number m
---@field direction_x? number of any length
---@field direction_y? number
---@field links? integer from 1 to 10000;
---@field link_length? number above 0.01; m, from pin to pin
---@field thickness? number above 0; m
---@field friction_torque? number at least 0; N m, of each pin
---@field damping? number at least 0; 1/s, of the air
---@field density? number at least 0; kg/m^2
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field hold_start? boolean whether the start is held
---@field start_body? Body by what; absent: the world
---@field hold_end? boolean whether the end is held
---@field end_body? Body by what; absent: the world
---@field data? table becomes body.data of every body
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by

---Rigid links, pinned end to end from x, y on.
---@param world World
---@param fields cairn.prefab.chain.Fields?
---@return Prefab prefab
function cairn.prefab.chain(world, fields) end

---@class cairn.prefab.rope.Fields
---@field x? number m
---@field y? number m
---@field to_x? number m
---@field to_y? number m
---@field length? number at least 0; m, at least the distance of the ends; 0: just that
---@field links? integer from 2 to 10000;
---@field radius? number above 0; m
---@field friction_torque? number at least 0; N m, of each pin
---@field damping? number at least 0; 1/s, of the air
---@field density? number at least 0; kg/m^2
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field hold_start? boolean whether the start is held
---@field start_body? Body by what; absent: the world
---@field hold_end? boolean whether the end is held
---@field end_body? Body by what; absent: the world
---@field data? table becomes body.data of every body
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by

---A rope from x, y to to_x, to_y. It bends freely; what hangs from it does not stretch it.
---@param world World
---@param fields cairn.prefab.rope.Fields?
---@return Prefab prefab
function cairn.prefab.rope(world, fields) end

---@class cairn.prefab.bridge.Fields
---@field x? number m
---@field y? number m
---@field to_x? number m
---@field to_y? number m
---@field planks? integer from 2 to 10000;
---@field slack? number from 0 to 1; how much longer than the straight way, a share
---@field thickness? number above 0; m
---@field friction_torque? number at least 0; N m, of each pin
---@field damping? number at least 0; 1/s, of the air
---@field break_force? number at least 0; N, of each joint
---@field break_torque? number at least 0; N m, of each joint
---@field density? number at least 0; kg/m^2
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field hold_start? boolean whether the start is held
---@field start_body? Body by what; absent: the world
---@field hold_end? boolean whether the end is held
---@field end_body? Body by what; absent: the world
---@field data? table becomes body.data of every body
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by

---Planks, pinned end to end from x, y to to_x, to_y.
---@param world World
---@param fields cairn.prefab.bridge.Fields?
---@return Prefab prefab
function cairn.prefab.bridge(world, fields) end

---@class cairn.prefab.vehicle.Fields
---@field x? number m
---@field y? number m
---@field length? number above 0; m, of the chassis
---@field height? number above 0; m, of the chassis
---@field suspension_frequency? number above 0; Hz
---@field suspension_damping? number at least 0; ratio; 1 is critical
---@field suspension_travel? number above 0; m, up and down
---@field drive_torque? number at least 0; N m, of each driven wheel
---@field brake_torque? number at least 0; N m, of each braked wheel
---@field density? number at least 0; kg/m^2, of the chassis
---@field friction? number at least 0; Coulomb coefficient, of the chassis
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field tyre_friction? number at least 0;
---@field tyre_density? number at least 0; kg/m^2
---@field wheels? table a list of { x = 0, y = 0, radius = 0.4, driven = true, braked = true }, m in the chassis; absent: two
---@field data? table becomes body.data of every body
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by

---A chassis on sprung wheels. See `prefab:drive`, `brake` and `coast`.
---@param world World
---@param fields cairn.prefab.vehicle.Fields?
---@return Prefab prefab
function cairn.prefab.vehicle(world, fields) end

---@class cairn.prefab.ragdoll.Fields
---@field x? number m
---@field y? number m
---@field scale? number above 0; 1: it is 1.6 m tall
---@field friction_torque? number at least 0; N m, of the hips, at scale 1
---@field spring_frequency? number at least 0; Hz, of springs towards how it is made; 0: limp
---@field spring_damping? number at least 0; ratio; 1 is critical
---@field linear_velocity_x? number m/s
---@field linear_velocity_y? number m/s
---@field density? number at least 0; kg/m^2
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field data? table becomes body.data of every body
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by

---A limp human figure of eleven bones with its feet at x, y, facing right; its bodies are `hip`, `torso`, `head`, then `upper_leg`, `lower_leg` twice and `upper_arm`, `lower_arm` twice. Without a `group` it has one of its own, so that its bones do not collide.
---@param world World
---@param fields cairn.prefab.ragdoll.Fields?
---@return Prefab prefab
function cairn.prefab.ragdoll(world, fields) end

---@class cairn.prefab.brick_wall.Fields
---@field x? number m
---@field y? number m
---@field columns? integer from 1 to 1000; bricks in a course
---@field courses? integer from 1 to 1000; a wall has at most 10000 bricks
---@field brick_width? number above 0.02; m
---@field brick_height? number above 0.01; m
---@field mortar? number above 0; N/m: what a metre of mortar bears
---@field density? number at least 0; kg/m^2
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field data? table becomes body.data of every body
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by

---Bricks in running bond, held by mortar that breaks. Its foot is at x, y.
---@param world World
---@param fields cairn.prefab.brick_wall.Fields?
---@return Prefab prefab
function cairn.prefab.brick_wall(world, fields) end

---@class cairn.prefab.blob.Fields
---@field x? number m
---@field y? number m
---@field rings? integer from 1 to 50; of pieces about the middle one
---@field piece_radius? number above 0; m
---@field frequency? number above 0; Hz, of each weld
---@field damping_ratio? number at least 0; 1 is critical
---@field break_force? number at least 0; N, of each joint
---@field break_torque? number at least 0; N m, of each joint
---@field density? number at least 0; kg/m^2
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field data? table becomes body.data of every body
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by

---A soft disc of round pieces, welded softly to their neighbours.
---@param world World
---@param fields cairn.prefab.blob.Fields?
---@return Prefab prefab
function cairn.prefab.blob(world, fields) end

---@class cairn.prefab.pendulum.Fields
---@field x? number m
---@field y? number m
---@field bobs? integer from 1 to 100; two make a double pendulum
---@field rod? number above 0; m, from centre to centre
---@field radius? number above 0; m, of each bob
---@field angle? number rad, from straight down
---@field damping? number at least 0; 1/s, of the air
---@field density? number at least 0; kg/m^2
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field hold_start? boolean whether the start is held
---@field start_body? Body by what; absent: the world
---@field data? table becomes body.data of every body
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by

---Bobs on rods without mass, hung from x, y.
---@param world World
---@param fields cairn.prefab.pendulum.Fields?
---@return Prefab prefab
function cairn.prefab.pendulum(world, fields) end

---@class cairn.prefab.windmill.Fields
---@field x? number m
---@field y? number m
---@field sails? integer from 2 to 24;
---@field hub_radius? number above 0; m
---@field sail_length? number above 0; m
---@field sail_width? number above 0; m
---@field tip_speed_ratio? number above 0; speed of the tips to that of the wind when nothing brakes
---@field clockwise? boolean which way it turns
---@field friction_torque? number at least 0; N m, of the hub
---@field density? number at least 0; kg/m^2
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field hold_start? boolean whether the start is held
---@field start_body? Body by what; absent: the world
---@field data? table becomes body.data of every body
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by

---A wheel of sails. See `prefab:blow`.
---@param world World
---@param fields cairn.prefab.windmill.Fields?
---@return Prefab prefab
function cairn.prefab.windmill(world, fields) end

---@class cairn.prefab.elevator.Fields
---@field x? number m
---@field y? number m
---@field width? number above 0; m, of the platform
---@field thickness? number above 0; m
---@field speed? number above 0; m/s
---@field load? number at least 0; kg, that it can carry
---@field density? number at least 0; kg/m^2
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field floors? table a list of heights over y, m, ascending, at least one; absent: { 0, 3, 6 }
---@field data? table becomes body.data of every body
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by

---A platform that goes between floors. See `prefab:send` and `is_at`; floor 0 is the first one.
---@param world World
---@param fields cairn.prefab.elevator.Fields?
---@return Prefab prefab
function cairn.prefab.elevator(world, fields) end

---@class cairn.prefab.gear_train.Fields
---@field x? number m
---@field y? number m
---@field direction_x? number of the row, of any length
---@field direction_y? number
---@field motor_speed? number rad/s, of the first wheel
---@field max_motor_torque? number at least 0; N m; 0: no motor
---@field density? number at least 0; kg/m^2
---@field friction? number at least 0; Coulomb coefficient
---@field restitution? number from 0 to 1; share of the approach speed given back
---@field radii? table a list of radii, m, at least one; absent: { 0.5, 1, 0.25 }
---@field data? table becomes body.data of every body
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events
---@field material? string a name of `cairn.physics.define_material`; what is not said beside it is as there
---@field rolling_resistance? number at least 0; coefficient: a torque of this times the normal force times the radius resists rolling
---@field surface_speed? number m/s; a conveyor belt: positive carries what lies on top to the right
---@field material_kind? integer from 0 to 63; what `world:set_material_rule` knows the material by

---Wheels in a row that turn each other without slip.
---@param world World
---@param fields cairn.prefab.gear_train.Fields?
---@return Prefab prefab
function cairn.prefab.gear_train(world, fields) end

---@class cairn.prefab.pulley_lift.Fields
---@field x? number m
---@field y? number m
---@field distance? number above 0; m, between the centres of the platforms
---@field travel? number above 0; m, up and down
---@field width? number above 0; m, of each platform
---@field thickness? number above 0; m
---@field rope? number above 0; m, up to the wheels
---@field ratio? number above 0; of a block and tackle on the right
---@field left_density? number at least 0; kg/m^2
---@field right_density? number at least 0; kg/m^2
---@field data? table becomes body.data of every body
---@field categories? integer bit set: what the shape is
---@field mask? integer bit set: what it collides with; -1 is everything
---@field group? integer from -2147483648 to 2147483647; two shapes of the same group other than 0: positive always collide, negative never
---@field contact_events? boolean "begin" and "end" events
---@field hit_events? boolean "hit" events

---Two platforms on one rope over two wheels.
---@param world World
---@param fields cairn.prefab.pulley_lift.Fields?
---@return Prefab prefab
function cairn.prefab.pulley_lift(world, fields) end

---@class Prefab
local Prefab = {}

---"rope", "vehicle" and so on: the name of its function.
---@return string kind
function Prefab:kind() end

---A new list of its bodies that live, in the order in which they were made: links, planks, bricks, pieces, bobs and wheels of gears from the first on; the chassis of a vehicle, then its wheels; the rotor of a windmill; the platform of an elevator; the static body that holds the others where it stands in the order.
---@return table bodies
function Prefab:bodies() end

---A new list of its joints that live.
---@return table joints
function Prefab:joints() end

---Of a vehicle: turns the driven wheels for that speed, to the right when positive.
---@param speed number [m/s]
function Prefab:drive(speed) end

---Of a vehicle: blocks the braked wheels.
function Prefab:brake() end

---Of a vehicle: lets all wheels run.
function Prefab:coast() end

---Of an elevator: sets it off to a floor, where it stops.
---@param floor integer
function Prefab:send(floor) end

---Of an elevator: whether it stands at the floor.
---@param floor integer
---@return boolean there
function Prefab:is_at(floor) end

---Of a windmill: what the wind does in the next step. Call it before each.
---@param wind number [m/s]
---@param dt number [s] above 0 and at most 1
function Prefab:blow(wind, dt) end

---Destroys what is left of it.
function Prefab:destroy() end

cairn.camera = {}

---@class cairn.camera.new.Fields
---@field x? number m; what the middle of the picture shows
---@field y? number m
---@field height? number from 1e-06 to 1000000000; m from the bottom to the top of the picture at zoom 1
---@field zoom? number above 0 and at most 1000000; 2 shows everything twice as large
---@field follow_rate? number above 0 and at most 1000000; 1/s; of the way to what it follows, 63 % is covered in 1 / rate
---@field dead_zone_width? number at least 0; m; inside this area around the middle
---@field dead_zone_height? number at least 0; m; what it follows does not move it
---@field shake_share? number at least 0; how far a shake of 1 moves the picture, in heights of the view

---Makes a camera.
---@param fields cairn.camera.new.Fields?
---@return Camera camera
function cairn.camera.new(fields) end

---@class Camera
local Camera = {}

---From here on drawing is in the world's metres, y up; only in `cairn.draw`. In a canvas the camera looks at the canvas: its position is in the middle of that, and its height from the bottom to the top.
function Camera:attach() end

---Drawing is again as it was before `attach`.
function Camera:detach() end

---Where in the world a point of the screen is.
---@param x number [px]
---@param y number [px]
---@return number x [m]
---@return number y [m]
function Camera:to_world(x, y) end

---Where on the screen a point of the world is.
---@param x number [m]
---@param y number [m]
---@return number x [px]
---@return number y [px]
function Camera:to_screen(x, y) end

---What `update` moves to from now on; without arguments it stays where it is. Call it in every update with the place of what is followed.
---@param x number? [m]
---@param y number? [m]
function Camera:follow(x, y) end

---Moves the camera on its way, and lets shakes fade. Once per update; pictures in between show it in between.
---@param dt number [s] above 0 and at most 1
function Camera:update(dt) end

---Shakes the picture; strengths add up to 1 at most and fade within a second.
---@param strength number at least 0
function Camera:shake(strength) end

---Nothing outside is shown; where the view is larger, it shows the middle. Without arguments: no bounds.
---@param left number? [m]
---@param bottom number? [m]
---@param right number? [m]
---@param top number? [m]
function Camera:set_bounds(left, bottom, right, top) end

---@return number zoom
function Camera:zoom() end

---2 shows everything twice as large as 1.
---@param zoom number above 0 and at most 1000000
function Camera:set_zoom(zoom) end

---Multiplies the zoom; what lies at that point of the screen stays there, as under a mouse wheel.
---@param x number [px]
---@param y number [px]
---@param factor number above 0 and at most 1000000
function Camera:zoom_at(x, y, factor) end

---What the picture shows.
---@return number left [m]
---@return number bottom [m]
---@return number right [m]
---@return number top [m]
function Camera:visible_area() end

---What the middle of the picture shows.
---@return number x [m]
---@return number y [m]
function Camera:position() end

---At once; what it follows it approaches from there.
---@param x number [m]
---@param y number [m]
function Camera:set_position(x, y) end

---How much of the world fits from the bottom to the top, at zoom 1.
---@return number height [m]
function Camera:height() end

---@param height number [m] from 1e-06 to 1000000000
function Camera:set_height(height) end

---How much of the world fits from left to right, at zoom 1.
---@return number width [m]
function Camera:width() end

---Moves the picture, not the position.
---@param dx number [px]
---@param dy number [px]
function Camera:set_shake(dx, dy) end

cairn.graphics = {}

---Of all that is drawn; it tints images. Starts white.
---@param r number
---@param g number
---@param b number
---@param a number?
function cairn.graphics.set_color(r, g, b, a) end

---@return number r
---@return number g
---@return number b
---@return number a
function cairn.graphics.color() end

---In the present units. Starts 1.
---@param width number at least 0
function cairn.graphics.set_line_width(width) end

---"alpha" covers, "add" adds light, "multiply" darkens, "screen" lightens up to white, "replace" takes the place of what was there, transparency too; edges mix by the share of a pixel that is covered, but are hard where a translucent color is drawn into a canvas.
---@param mode string
function cairn.graphics.set_blend_mode(mode) end

---Only what lies inside is drawn; screen pixels, whatever the transform. Without arguments: everything.
---@param x number? [px]
---@param y number? [px]
---@param width number? [px] at least 0
---@param height number? [px] at least 0
function cairn.graphics.set_scissor(x, y, width, height) end

---Fills the picture.
---@param r number
---@param g number
---@param b number
function cairn.graphics.clear(r, g, b) end

---Remembers the transform.
function cairn.graphics.push() end

---Goes back to the transform of the last push.
function cairn.graphics.pop() end

---@param x number
---@param y number
function cairn.graphics.translate(x, y) end

---From the x axis towards the y axis.
---@param angle number [rad]
function cairn.graphics.rotate(angle) end

---About (0, 0). Negative factors mirror what is drawn, pictures and texts too: `scale(-1, 1)` from left to right, `scale(1, -1)` from top to bottom. Under a camera the letters of texts keep their size and the way they stand.
---@param x number
---@param y number?
function cairn.graphics.scale(x, y) end

---(1, 0) goes to (1, y), and (0, 1) to (x, 1).
---@param x number
---@param y number
function cairn.graphics.shear(x, y) end

---Forgets the transforms since the last push: drawing is in screen pixels.
function cairn.graphics.origin() end

---Where on the screen, or in the canvas, a point lies.
---@param x number
---@param y number
---@return number x [px]
---@return number y [px]
function cairn.graphics.transform_point(x, y) end

---The point that is drawn there.
---@param x number [px]
---@param y number [px]
---@return number x
---@return number y
function cairn.graphics.inverse_transform_point(x, y) end

---`mode` is "fill" or "line"; (x, y) is the corner of least x and y; the radius rounds the corners inward.
---@param mode string
---@param x number
---@param y number
---@param width number at least 0
---@param height number at least 0
---@param radius number? at least 0
function cairn.graphics.rectangle(mode, x, y, width, height, radius) end

---@param mode string
---@param x number
---@param y number
---@param radius number at least 0
function cairn.graphics.circle(mode, x, y, radius) end

---@param mode string
---@param x number
---@param y number
---@param radius_x number at least 0
---@param radius_y number at least 0
function cairn.graphics.ellipse(mode, x, y, radius_x, radius_y) end

---"fill" draws the slice of a disc between two angles, "line" the arc alone.
---@param mode string
---@param x number
---@param y number
---@param radius number at least 0
---@param from number [rad]
---@param to number [rad]
function cairn.graphics.arc(mode, x, y, radius, from, to) end

---@param mode string
---@param x1 number
---@param y1 number
---@param x2 number
---@param y2 number
---@param radius number at least 0
function cairn.graphics.capsule(mode, x1, y1, x2, y2, radius) end

---Through points = { x1, y1, x2, y2, ... } or { {x1, y1}, {x2, y2}, ... }. It may have dents; with "fill" its sides must not cross.
---@param mode string
---@param points table
function cairn.graphics.polygon(mode, points) end

---Through all points: `line{ x1, y1, x2, y2, ... }`, `line{ {x1, y1}, {x2, y2}, ... }`, or the numbers as arguments, `line(x1, y1, x2, y2, ...)`.
---@param points any
function cairn.graphics.line(points) end

---Triangles without smooth edges: three vertices each, { x, y, r, g, b, a, ... }, with an image { x, y, r, g, b, a, u, v, ... }. For gradients.
---@param vertices table
---@param image Image|Canvas|Quad?
function cairn.graphics.mesh(vertices, image) end

---Loads a PNG or JPEG file; the same path gives the same picture. Where it is scaled, "linear" mixes its pixels and "nearest" shows them as they are: pixel art. Wherever an image is drawn, a Canvas or a Quad can be too.
---@param path string
---@param filter string?
---@return Image image
function cairn.graphics.new_image(path, filter) end

---Makes a transparent picture to draw into. Its pixels are logical ones.
---@param width integer [px] from 1 to 8192
---@param height integer [px] from 1 to 8192
---@param filter string?
---@return Canvas canvas
function cairn.graphics.new_canvas(width, height, filter) end

---A part of an image, to be drawn like one; it must lie inside.
---@param image Image|Canvas|Quad
---@param x number [px]
---@param y number [px]
---@param width number [px]
---@param height number [px]
---@return Quad quad
function cairn.graphics.new_quad(image, x, y, width, height) end

---Loads many named parts of one image: a JSON file as TexturePacker, free-tex-packer and Aseprite write them, "hash" or "array", without rotation and trimming.
---@param path string
---@param filter string?
---@return Atlas atlas
function cairn.graphics.new_atlas(path, filter) end

---A list of sprites from one image that is drawn with one call.
---@param image Image|Canvas|Quad
---@return Batch batch
function cairn.graphics.new_batch(image) end

---Draws an image with its origin (pixels from its top left) at (x, y). Under a camera the scale is metres per pixel of the image.
---@param image Image|Canvas|Quad
---@param x number
---@param y number
---@param angle number? [rad]
---@param scale_x number?
---@param scale_y number?
---@param origin_x number? [px]
---@param origin_y number? [px]
function cairn.graphics.draw(image, x, y, angle, scale_x, scale_y, origin_x, origin_y) end

---Draws an image centred at (x, y) with a size in the present units.
---@param image Image|Canvas|Quad
---@param x number
---@param y number
---@param width number
---@param height number
---@param angle number? [rad]
function cairn.graphics.draw_sized(image, x, y, width, height, angle) end

---As draw_sized, with a part of the image.
---@param image Image|Canvas|Quad
---@param source_x number [px]
---@param source_y number [px]
---@param source_width number [px] above 0
---@param source_height number [px] above 0
---@param x number
---@param y number
---@param width number
---@param height number
---@param angle number? [rad]
function cairn.graphics.draw_region(image, source_x, source_y, source_width, source_height, x, y, width, height, angle) end

---A polygon whose sides do not cross, { x1, y1, ... }, filled with the image; uvs = { u1, v1, ... } says which place of the image, 0 to 1 from its top left, lies at each point. The image is laid on flat: three of the points decide how.
---@param image Image|Canvas|Quad
---@param points table
---@param uvs table
function cairn.graphics.draw_polygon(image, points, uvs) end

---Fills a rectangle with an image whose corners keep their size and whose sides are stretched only along themselves: frames, panels, buttons. The borders are of the image; `scale` is how large one of its pixels is drawn.
---@param image Image|Canvas|Quad
---@param x number
---@param y number
---@param width number at least 0
---@param height number at least 0
---@param left number [px] at least 0
---@param top number? [px] at least 0
---@param right number? [px] at least 0
---@param bottom number? [px] at least 0
---@param scale number? above 0
function cairn.graphics.draw_nine_patch(image, x, y, width, height, left, top, right, bottom, scale) end

---Loads a TrueType font.
---@param size number [px] from 4 to 256
---@param path string?
---@return Font font
function cairn.graphics.new_font(size, path) end

---Starts with the default font at 18 pixels.
---@param font Font
function cairn.graphics.set_font(font) end

---(x, y) is the top of the text at its left, center or right, by `align`; with a wrap width, lines are broken to fit x .. x + wrap_width and aligned inside. Under a camera (x, y) is in the world and the letters keep their size in pixels.
---@param text any
---@param x number
---@param y number
---@param align string?
---@param wrap_width number? [px] at least 0
function cairn.graphics.print(text, x, y, align, wrap_width) end

---Draws the body's shapes between the last two steps: with `body.data.image`, an Image, Canvas or Quad spread over each shape, or `body.data.color`, {r, g, b, a?}, or a default. Not when `body.data.visible` is false.
---@param body Body
function cairn.graphics.draw_body(body) end

---Draws every body, in the order of `world:bodies()`, without its sensors.
---@param world World
function cairn.graphics.draw_world(world) end

---@class cairn.graphics.draw_debug.Fields
---@field shapes? boolean true outlines, with a mark of how they are turned
---@field contacts? boolean points, and impulses along normal and surface
---@field joints? boolean by kind, with anchors and limits
---@field islands? boolean one color for bodies that fall asleep together
---@field boxes? boolean of the broad phase
---@field centers? boolean of mass

---Draws what the physics works with, under the present camera: `draw_debug(world, { islands = true })`. Sleeping bodies are dark. In a window, F2 draws it over every game.
---@param world World
---@param options table?
function cairn.graphics.draw_debug(world, options) end

---The logical size of the picture.
---@return integer width [px]
---@return integer height [px]
function cairn.graphics.size() end

---How far the picture lies between the last two updates, 0 to 1.
---@return number alpha
function cairn.graphics.alpha() end

---Of the picture before.
---@return integer draw_calls
---@return integer vertices
function cairn.graphics.stats() end

---@class Image
local Image = {}

---@return integer width [px]
---@return integer height [px]
function Image:size() end

---@return integer width [px]
function Image:width() end

---@return integer height [px]
function Image:height() end

---@class Font
local Font = {}

---The width of the longest line and the height of all lines.
---@param text any
---@param wrap_width number? [px] at least 0
---@return number width [px]
---@return number height [px]
function Font:measure(text, wrap_width) end

---From the top of one line to the top of the next.
---@return number height [px]
function Font:height() end

---@return number size [px]
function Font:size() end

---@class Canvas
local Canvas = {}

---From here on drawing goes into the canvas, from its top left, with transforms, blend mode and scissor of its own; only in `cairn.draw`. With a color it is filled with it first, else it keeps what it shows, from picture to picture too.
---@param r number?
---@param g number?
---@param b number?
---@param a number?
function Canvas:attach(r, g, b, a) end

---Drawing goes where it went before `attach`.
function Canvas:detach() end

---@return integer width [px]
---@return integer height [px]
function Canvas:size() end

---@class Quad
local Quad = {}

---@return number width [px]
---@return number height [px]
function Quad:size() end

---Where in its image it lies.
---@return number x [px]
---@return number y [px]
---@return number width [px]
---@return number height [px]
function Quad:region() end

---@class Atlas
local Atlas = {}

---A part by its name; an unknown one is an error.
---@param name string
---@return Quad quad
function Atlas:quad(name) end

---A new list of all names, as the file has them.
---@return string[] names
function Atlas:names() end

---@class Batch
local Batch = {}

---Adds a sprite, placed as cairn.graphics.draw places images: the whole image, or the quad, which must be a part of it.
---@param x number
---@param y number
---@param angle number? [rad]
---@param scale_x number?
---@param scale_y number?
---@param origin_x number? [px]
---@param origin_y number? [px]
---@param quad Image|Canvas|Quad?
---@return integer index
function Batch:add(x, y, angle, scale_x, scale_y, origin_x, origin_y, quad) end

---Adds a sprite for each body of the world that is a key of `quads`, where it is between the last two steps: the Quad that is its value, or the whole image for `true`. `scale` is metres per pixel of the image.
---@param world World
---@param quads table
---@param scale number
function Batch:add_bodies(world, quads, scale) end

---Tints what is added from here on.
---@param r number
---@param g number
---@param b number
---@param a number?
function Batch:set_color(r, g, b, a) end

---Takes all sprites out.
function Batch:clear() end

---How many sprites it holds.
---@return integer count
function Batch:count() end

---Draws all of it in the order of adding; only in `cairn.draw`.
function Batch:draw() end

cairn.particles = {}

---@class cairn.particles.new.Fields
---@field max_count? integer from 1 to 100000; how many may live
---@field rate? number from 0 to 1000000; 1/s; born per second while it is started
---@field x? number where they are born
---@field y? number
---@field area_width? number at least 0; of the rectangle in which they are born
---@field area_height? number at least 0;
---@field lifetime? number above 0 and at most 1000000; s
---@field lifetime_max? number s; with it, any between the two
---@field speed? number per second
---@field speed_max? number with it, any between the two
---@field direction? number rad, from the x axis towards the y axis
---@field spread? number rad, around the direction
---@field acceleration_x? number per second squared
---@field acceleration_y? number
---@field damping? number at least 0; 1/s; c in v e^(-c t)
---@field size? number at least 0; at birth
---@field size_max? number with it, any between the two
---@field size_end? number at least 0; at the end; absent: as at birth
---@field rotation? number rad, at birth
---@field rotation_max? number rad; with it, any between the two
---@field spin? number rad/s
---@field spin_max? number rad/s; with it, any between the two
---@field colors? table { {r, g, b, a?}, ... } over the lifetime, evenly; absent: white that fades
---@field blend? string "alpha" or "add"

---Makes an emitter, which is stopped. Each particle is a square of the image, or a soft disc. Lengths are in the units it is drawn in: pixels, or metres under a camera.
---@param fields cairn.particles.new.Fields?
---@param image Image|Canvas|Quad?
---@return Particles particles
function cairn.particles.new(fields, image) end

---@class Particles
local Particles = {}

---That many at once, where it stands or at (x, y).
---@param count integer at least 0
---@param x number?
---@param y number?
function Particles:emit(count, x, y) end

---From now on `rate` are born per second.
function Particles:start() end

---None are born any more; those that live go on.
function Particles:stop() end

---Whether it is started, or some still live.
---@return boolean active
function Particles:is_active() end

---How many live.
---@return integer count
function Particles:count() end

---Takes all away.
function Particles:clear() end

---@return number x
---@return number y
function Particles:position() end

---Where the next ones are born.
---@param x number
---@param y number
function Particles:set_position(x, y) end

---Where the next ones fly, as the flame of a rocket that turns.
---@param direction number [rad]
function Particles:set_direction(direction) end

---How many are born per second from now on.
---@param rate number [1/s] from 0 to 1000000
function Particles:set_rate(rate) end

---Moves them on; once per update.
---@param dt number [s] above 0 and at most 1
function Particles:update(dt) end

---All with one draw call, tinted by the color that is set; only in `cairn.draw`.
function Particles:draw() end

cairn.tilemap = {}

---@class cairn.tilemap.load.Fields
---@field scale? number above 0 and at most 1000000; units per pixel of the map: metres, under a camera
---@field y_up? boolean whether y points up, as under a camera
---@field filter? string of its pictures: "linear", or "nearest" for pixel art

---Loads an orthogonal, isometric, staggered or hexagonal map, .tmx or .tmj, with its tile sets and pictures, in which the transparent color that the editor was told is not seen. An infinite one is as large as what was drawn in it: its upper left corner is that of the first tile. Layer data may be CSV or base64, plain or packed with zlib or gzip. Places are those of the picture, in which a cell may be a diamond or a hexagon.
---@param path string
---@param fields cairn.tilemap.load.Fields?
---@return TileMap map
function cairn.tilemap.load(path, fields) end

---@class TileMap
local TileMap = {}

---Draws a layer, or all that are visible; only what the picture shows, with the color that is set. Of object layers it draws the tiles, sized, turned and ordered as in the editor, of image layers the picture, repeated as the map says. Layers with parallax move as in the editor when the middle of the picture does. Under a camera load it with `y_up = true` and a scale.
---@param layer string?
function TileMap:draw(layer) end

---In the map's units; it begins at (0, 0).
---@return number width
---@return number height
function TileMap:size() end

---@return integer columns
---@return integer rows
function TileMap:cells() end

---In the map's units.
---@return number width
---@return number height
function TileMap:cell_size() end

---A new table of the map's own.
---@return table properties
function TileMap:properties() end

---A new list, the lowest first; those in groups are called "group/layer".
---@return string[] names
function TileMap:layers() end

---The number of a tile among all sets, 0 for none. Columns and rows count from 1, at the top left.
---@param layer string
---@param column integer
---@param row integer
---@return integer id
function TileMap:tile(layer, column, row) end

---Puts a tile there, or 0 for none.
---@param layer string
---@param column integer
---@param row integer
---@param id integer
function TileMap:set_tile(layer, column, row, id) end

---A new table of what the tile set says about a tile; `class` is its class.
---@param id integer
---@return table properties
function TileMap:tile_properties(id) end

---The cell that holds a place, also outside of the map.
---@param x number
---@param y number
---@return integer column
---@return integer row
function TileMap:cell_at(x, y) end

---The middle of a cell.
---@param column integer
---@param row integer
---@return number x
---@return number y
function TileMap:cell_center(column, row) end

---Covers the layer's tiles, all or those whose property is there and not false, with few rectangles: a list of { x, y, width, height }, x and y being the middle, as `body:add_box` takes them. On all but orthogonal maps { x, y, points }, the points from the middle, as `world:add_polygon` takes them.
---@param layer string
---@param property string?
---@return table rectangles
function TileMap:solids(layer, property) end

---A new list of tables: id, name, class, shape ("rectangle", "ellipse", "point", "polygon", "polyline", "tile" or "text"), x, y (the middle), width, height, angle, visible, properties, points, tile, text. A rectangle on an isometric map is a parallelogram, with its corners as points. A tile without a width or a height has that of its set, and the set's object alignment says where it stands, as in the editor.
---@param layer string?
---@return table objects
function TileMap:objects(layer) end

cairn.ui = {}

---@class cairn.ui.new.Fields
---@field x? number px; the panel's middle; absent: that of the screen, also when its size changes
---@field y? number px
---@field width? number above 40 and at most 8192; px
---@field max_height? number above 100 and at most 8192; px of the panel; what does not fit is scrolled
---@field row_height? number above 10 and at most 400; px; less is hard to hit with a finger
---@field font_size? number from 4 to 256; px
---@field title? string above the rows
---@field accent? table {r, g, b}: of the title, the focus and values
---@field back? function called for escape and the gamepad's "b"

---Makes an empty panel.
---@param fields cairn.ui.new.Fields?
---@return Ui ui
function cairn.ui.new(fields) end

---@class Ui
local Ui = {}

---@class Ui.add_label.Fields
---@field text? string what stands on it
---@field same_row? boolean stands beside the widget before it

---Adds a text, which may take several lines; those of other widgets are shortened where there is no room for them. Widgets are numbered from 1, from the top.
---@param fields Ui.add_label.Fields
---@return integer widget
function Ui:add_label(fields) end

---@class Ui.add_button.Fields
---@field action? function called when it is pressed
---@field text? string what stands on it
---@field enabled? boolean whether it can be used
---@field same_row? boolean stands beside the widget before it

---Adds a button.
---@param fields Ui.add_button.Fields
---@return integer widget
function Ui:add_button(fields) end

---@class Ui.add_toggle.Fields
---@field value? boolean
---@field changed? function called with true or false
---@field text? string what stands on it
---@field enabled? boolean whether it can be used
---@field same_row? boolean stands beside the widget before it

---Adds a switch that is on or off.
---@param fields Ui.add_toggle.Fields
---@return integer widget
function Ui:add_toggle(fields) end

---@class Ui.add_slider.Fields
---@field value? number from low to high; absent: 0, or the end next to it
---@field low? number
---@field high? number above low
---@field step? number above 0; what one press changes; steps begin at low
---@field changed? function called with the number
---@field text? string what stands on it
---@field enabled? boolean whether it can be used
---@field same_row? boolean stands beside the widget before it

---Adds a number between two ends.
---@param fields Ui.add_slider.Fields
---@return integer widget
function Ui:add_slider(fields) end

---@class Ui.add_choice.Fields
---@field choices table a list of strings
---@field value? integer counts from 1
---@field changed? function called with the number and the string
---@field text? string what stands on it
---@field enabled? boolean whether it can be used
---@field same_row? boolean stands beside the widget before it

---Adds one of several words.
---@param fields Ui.add_choice.Fields
---@return integer widget
function Ui:add_choice(fields) end

---@class Ui.add_text.Fields
---@field value? string at most max_length characters
---@field max_length? integer from 1 to 1000; characters
---@field changed? function called with the text
---@field text? string what stands on it
---@field enabled? boolean whether it can be used
---@field same_row? boolean stands beside the widget before it

---Adds a field that text is typed into while it is open: return, space, a click or the gamepad's "a" opens it; return, escape, tab, a click elsewhere or "a" and "b" close it. All keys, texts and buttons of gamepads meanwhile go into it alone: neither callbacks, `cairn.input` and actions nor other menus get them. Sticks still move, and releases of what was held before still come.
---@param fields Ui.add_text.Fields
---@return integer widget
function Ui:add_text(fields) end

---Takes the events of this update, and calls what was given for the widgets. Once per update of the scene that has it.
function Ui:update() end

---In screen pixels, whatever the transform; only in `cairn.draw`.
function Ui:draw() end

---A boolean, a number, the number of a choice, or a text; nil of labels and buttons.
---@param widget integer
---@return any value
function Ui:value(widget) end

---Without calling `changed`. A value that the widget cannot have is an error.
---@param widget integer
---@param value any
function Ui:set_value(widget, value) end

---What stands on it.
---@param widget integer
---@param text string
function Ui:set_text(widget, text) end

---@param widget integer
---@param enabled boolean
function Ui:set_enabled(widget, enabled) end

---@param title string
function Ui:set_title(title) end

---The one that keys and gamepads act on; 0: none.
---@return integer widget
function Ui:focus() end

---Of a label or a disabled widget it is an error.
---@param widget integer
function Ui:set_focus(widget) end

---Whether a text field of it is open, so that keys and buttons go there and not to the game.
---@return boolean typing
function Ui:is_typing() end

---Takes all widgets out.
function Ui:clear() end

cairn.text = {}

---@class cairn.text.new.Fields
---@field width? number at least 0; px; lines are broken to be no wider; 0: only at line ends
---@field align? string "left", "center" or "right"
---@field line_spacing? number above 0 and at most 100; times the font's height

---Makes a text of a string, or of parts in colors of their own: `cairn.text.new({ "Press ", { "A", 1, 0.8, 0.3 }, " to jump" }, { width = 300 })`. Without a font it has the default one.
---@param parts any
---@param fields cairn.text.new.Fields?
---@param font Font?
---@return Text text
function cairn.text.new(parts, fields, font) end

---The lines of a text that is broken to be no wider.
---@param text string
---@param width number [px] at least 0
---@param font Font?
---@return string[] lines
function cairn.text.wrap(text, width, font) end

---@class Text
local Text = {}

---(x, y) is the top, at the left, in the middle or at the right by its alignment; with a width, of the left end of its box. It is tinted by the color that is set; only in `cairn.draw`.
---@param x number
---@param y number
function Text:draw(x, y) end

---@return number width [px]
---@return number height [px]
function Text:size() end

---@return integer characters
function Text:length() end

---Only so many are drawn, where they will stand when all are: for text that is typed before the player's eyes. Nil: all.
---@param characters integer? at least 0
function Text:set_shown(characters) end

---Another string, or other parts.
---@param parts any
function Text:set_text(parts) end

cairn.audio = {}

---@class cairn.audio.play.Fields
---@field volume? number at least 0; more than 1 is as 1
---@field pan? number -1 left to 1 right, and beyond as there
---@field pitch? number above 0; 0.25 to 4, and beyond as there
---@field loop? boolean
---@field group? string "sfx", or one made with new_group

---Starts a sound, an Ogg Vorbis or WAV file. The voice is an integer, 0 when the rate cap swallowed the sound.
---@param path string
---@param fields cairn.audio.play.Fields?
---@return integer voice
function cairn.audio.play(path, fields) end

---Nothing happens when the voice has ended.
---@param voice integer
function cairn.audio.stop(voice) end

---All sounds; the music goes on.
function cairn.audio.stop_all() end

---@param voice integer
---@return boolean playing
function cairn.audio.is_playing(voice) end

---More than 1 is as 1.
---@param voice integer
---@param volume number at least 0
function cairn.audio.set_voice_volume(voice, volume) end

----1 left to 1 right, and beyond as there.
---@param voice integer
---@param pan number
function cairn.audio.set_voice_pan(voice, pan) end

---0.25 to 4, and beyond as there: speed and pitch from now on, as of an engine that turns faster.
---@param voice integer
---@param pitch number above 0
function cairn.audio.set_voice_pitch(voice, pitch) end

---Loads a sound and says how long it plays at pitch 1.
---@param path string
---@return number seconds [s]
function cairn.audio.duration(path) end

---The same sound starts at most once per `seconds` and plays in at most `voices` voices; every sound begins with 0.03 and 8.
---@param path string
---@param seconds number [s] at least 0
---@param voices integer from 1 to 32
function cairn.audio.set_rate_cap(path, seconds, voices) end

---@class cairn.audio.play_music.Fields
---@field volume? number from 0 to 1;
---@field loop? boolean
---@field fade? number from 0 to 3600; s in which it swells from silence

---Replaces the music that plays.
---@param path string
---@param fields cairn.audio.play_music.Fields?
function cairn.audio.play_music(path, fields) end

---Within that time it falls silent.
---@param fade number? [s] from 0 to 3600
function cairn.audio.stop_music(fade) end

---Of the music that plays.
---@param volume number from 0 to 1
function cairn.audio.set_music_volume(volume) end

---The file of the music that plays, or nil.
---@return string? path
function cairn.audio.music() end

---Makes a group of sounds beside "sfx" and "music", for a volume and a pause of its own: "ui", "speech".
---@param name string
function cairn.audio.new_group(name) end

---@param group string
---@param volume number from 0 to 1
function cairn.audio.set_volume(group, volume) end

---What plays in the group stands still, and so does what is started in it, until it is resumed.
---@param group string
function cairn.audio.pause(group) end

---@param group string
function cairn.audio.resume(group) end

---@param group string
---@return boolean paused
function cairn.audio.is_paused(group) end

---@param group string
---@return number volume
function cairn.audio.volume(group) end

cairn.input = {}

---Keys: "a" to "z", "0" to "9", "space", "return", "escape", "tab", "backspace", "delete", "insert", "home", "end", "page_up", "page_down", "left", "right", "up", "down", "f1" to "f12", "left_shift", "right_shift", "left_control", "right_control", "left_alt", "right_alt", punctuation by its sign ("-"), "keypad_0", ...
---@param key string
---@return boolean down
function cairn.input.is_down(key) end

---Buttons: "left", "middle", "right", "x1", "x2". The first finger is the left button too.
---@param button string
---@return boolean down
function cairn.input.is_mouse_down(button) end

---Logical pixels.
---@return number x [px]
---@return number y [px]
function cairn.input.mouse_position() end

---Names what the player does, `cairn.input.bind("jump", { "space", "gamepad_a", "mouse_left" })`, instead of what was bound before. Sources are keys, "mouse_" with a button, "gamepad_" with a button or with a stick and its direction ("gamepad_left_x+", "gamepad_right_y-", "gamepad_left_trigger"); "gamepad2_a" is the second gamepad's alone.
---@param action string
---@param sources table
function cairn.input.bind(action, sources) end

---A new list of what an action is bound to.
---@param action string
---@return string[] sources
function cairn.input.sources(action) end

---A new list of all actions, sorted.
---@return string[] actions
function cairn.input.actions() end

---@param action string
---@return boolean down
function cairn.input.is_action_down(action) end

---Whether it went down in this update.
---@param action string
---@return boolean pressed
function cairn.input.was_pressed(action) end

---Whether it went up in this update.
---@param action string
---@return boolean released
function cairn.input.was_released(action) end

---0 to 1: how far its strongest source is pressed.
---@param action string
---@return number value
function cairn.input.action_value(action) end

----1 to 1, from two actions: `cairn.input.axis("left", "right")`.
---@param negative string
---@param positive string
---@return number value
function cairn.input.axis(negative, positive) end

---Calls `listener(source)` with the next thing that is pressed, for rebinding; that event goes nowhere else.
---@param listener function
function cairn.input.listen(listener) end

function cairn.input.stop_listening() end

---A new list of the numbers of the gamepads that are connected, from 1.
---@return integer[] numbers
function cairn.input.gamepads() end

---Empty when it is not connected.
---@param gamepad integer from 1 to 8
---@return string name
function cairn.input.gamepad_name(gamepad) end

---Buttons by their place on most gamepads: "a" (below), "b" (right), "x" (left), "y" (above), "back", "guide", "start", "left_stick", "right_stick", "left_shoulder", "right_shoulder", "dpad_up", "dpad_down", "dpad_left", "dpad_right".
---@param gamepad integer from 1 to 8
---@param button string
---@return boolean down
function cairn.input.is_gamepad_down(gamepad, button) end

---"left_x", "left_y", "right_x", "right_y": -1 to 1, right and up positive; "left_trigger", "right_trigger": 0 to 1. Small tremors around the middle are 0.
---@param gamepad integer from 1 to 8
---@param axis string
---@return number value
function cairn.input.gamepad_axis(gamepad, axis) end

---Shakes it; `low` is the strength of its heavier weight.
---@param gamepad integer from 1 to 8
---@param strength number from 0 to 1
---@param seconds number [s] from 0 to 60
---@param low number? from 0 to 1
function cairn.input.rumble(gamepad, strength, seconds, low) end

---A new list of the fingers that touch, from 1.
---@return integer[] numbers
function cairn.input.touches() end

---Where a finger is, or nil.
---@param touch integer from 1 to 10
---@return number? x [px]
---@return number? y [px]
function cairn.input.touch_position(touch) end

cairn.window = {}

---Logical pixels: what the game draws in and where the mouse is. As conf.lua says, until `set_logical_size` or, with `scaling = "follow"`, the window changes it.
---@return integer width [px]
---@return integer height [px]
function cairn.window.size() end

---From the next picture on the game draws in so many pixels, 1 to 8192 a side, scaled to fit the window.
---@param width integer [px] from 1 to 8192
---@param height integer [px] from 1 to 8192
function cairn.window.set_logical_size(width, height) end

---Of the window itself, in the desktop's points. The desktop decides it, so nothing but drawing may depend on it. Headless: as conf.lua or `set_window_size` said.
---@return integer width
---@return integer height
function cairn.window.window_size() end

---Points of the desktop, 1 to 8192 a side; leaves full screen. With `scaling = "follow"` the picture follows, and `cairn.window_resized` is called.
---@param width integer from 1 to 8192
---@param height integer from 1 to 8192
function cairn.window.set_window_size(width, height) end

---@param title string
function cairn.window.set_title(title) end

---Over the whole display, in its own resolution.
---@param on boolean
function cairn.window.set_fullscreen(on) end

---@return boolean on
function cairn.window.is_fullscreen() end

---Whether the player can change the window's size.
---@param on boolean
function cairn.window.set_resizable(on) end

---@return boolean on
function cairn.window.is_resizable() end

---How many pixels of the display a logical pixel is wide: more than 1 on dense displays and in large windows. A canvas that is to look sharp has as many times its size, and is drawn as many times smaller; text, shapes and fonts follow by themselves. It differs between machines, so nothing but drawing may depend on it.
---@return number scale
function cairn.window.pixel_scale() end

---@return boolean focus
function cairn.window.has_focus() end

cairn.files = {}

---The contents of a file.
---@param path string
---@return string text
function cairn.files.read(path) end

---Replaces a file below `save/` in one stroke; folders are made as needed.
---@param path string
---@param text string
function cairn.files.write(path, text) end

---Deletes a file below `save/`.
---@param path string
function cairn.files.remove(path) end

---@param path string
---@return boolean exists
function cairn.files.exists(path) end

---@param path string
---@return boolean folder
function cairn.files.is_folder(path) end

---Sorted names of what a folder holds; "" is the game.
---@param folder string
---@return table names
function cairn.files.list(folder) end

---Reads Lua table text, `return { ... }`, as data: it is never run.
---@param path string
---@return table data
function cairn.files.read_data(path) end

---Writes a table of numbers, strings, booleans and such tables so that read_data reads it back.
---@param path string
---@param data table
function cairn.files.write_data(path, data) end

cairn.random = {}

---In [0, 1).
---@return number number
function cairn.random.uniform() end

---In [low, high).
---@param low number
---@param high number
---@return number number
function cairn.random.number(low, high) end

---In [low, high], both included, all equally likely.
---@param low integer
---@param high integer
---@return integer integer
function cairn.random.integer(low, high) end

---Normally distributed: most lie near the mean.
---@param mean number?
---@param deviation number? at least 0
---@return number number
function cairn.random.normal(mean, deviation) end

---True with that probability.
---@param probability number from 0 to 1
---@return boolean happens
function cairn.random.chance(probability) end

---One of a list's members, all equally likely.
---@param list table
---@return any member
function cairn.random.choose(list) end

---Brings the members of a list into a random order, all equally likely.
---@param list table
function cairn.random.shuffle(list) end

---Starts the stream anew.
---@param seed integer
function cairn.random.seed(seed) end

---A generator of its own; it is not part of the state hash.
---@param seed integer
---@return Random random
function cairn.random.new(seed) end

---@class Random
local Random = {}

---In [0, 1).
---@return number number
function Random:uniform() end

---In [low, high).
---@param low number
---@param high number
---@return number number
function Random:number(low, high) end

---In [low, high], both included.
---@param low integer
---@param high integer
---@return integer integer
function Random:integer(low, high) end

---Normally distributed.
---@param mean number?
---@param deviation number? at least 0
---@return number number
function Random:normal(mean, deviation) end

---True with that probability.
---@param probability number from 0 to 1
---@return boolean happens
function Random:chance(probability) end

---One of a list's members.
---@param list table
---@return any member
function Random:choose(list) end

---Brings the members of a list into a random order.
---@param list table
function Random:shuffle(list) end

---Starts the stream anew.
---@param seed integer
function Random:seed(seed) end

cairn.timer = {}

---Calls `action()` once.
---@param seconds number [s] at least 0
---@param action function
---@return Timer timer
function cairn.timer.after(seconds, action) end

---Calls `action()` again and again, until it returns false: in the first update after each whole number of periods, and at most once in an update.
---@param seconds number [s] at least 0
---@param action function
---@return Timer timer
function cairn.timer.every(seconds, action) end

---Game time since the start.
---@return number seconds [s]
function cairn.timer.time() end

---Updates since the start: 1 in the first.
---@return integer count
function cairn.timer.frame() end

---@class Timer
local Timer = {}

---The action is not called any more.
function Timer:cancel() end

cairn.tween = {}

---@class cairn.tween.to.Fields
---@field ease? string "linear", or quad, cubic, quart, quint, sine, expo, circ, back, elastic or bounce with _in, _out or _in_out: where it is slow
---@field delay? number at least 0; s until it begins
---@field repeats? integer at least -1; how often it runs again; -1: until it is cancelled
---@field yoyo? boolean every second run goes back
---@field done? function called at the end

---Moves number fields of a table to goals: `cairn.tween.to(menu, { y = 100, alpha = 1 }, 0.4)`. It starts from the values at its beginning. A newer tween of the same field takes it over. A field that is no number any more ends it with an error.
---@param target table
---@param goals table
---@param seconds number [s] at least 0
---@param fields cairn.tween.to.Fields?
---@return Tween tween
function cairn.tween.to(target, goals, seconds, fields) end

---Ends all tweens of a table where they are.
---@param target table
function cairn.tween.cancel_all(target) end

---What a curve makes of t, 0 to 1.
---@param name string
---@param t number
---@return number share
function cairn.tween.ease(name, t) end

---@class Tween
local Tween = {}

---Ends it where it is; `done` is not called.
function Tween:cancel() end

---Whether it waits or moves.
---@return boolean active
function Tween:is_active() end

cairn.scene = {}

---Puts a scene on top: `pause()` of the one below, then `enter(...)` of the new one.
---@param scene table
---@param ... any?
function cairn.scene.push(scene, ...) end

---Leaves the top scene: its `leave()`, then `resume(...)` of the one below, if there is one.
---@param ... any?
function cairn.scene.pop(...) end

---Puts a scene in the place of the top one: `leave()` of the old, `enter(...)` of the new.
---@param scene table
---@param ... any?
function cairn.scene.switch(scene, ...) end

---The top scene, or nil.
---@return table? scene
function cairn.scene.current() end

---How many scenes are on the stack.
---@return integer count
function cairn.scene.count() end

cairn.data = {}

---Reads Lua table text as data, never running it, checks it by the schema and fills in defaults. A fault is an error such as `levels/level-01.lua:14: pieces[3].material = "wod": no such material; did you mean "wood"? (ice, stone, wood)`.
---@param path string
---@param schema table
---@return table data
function cairn.data.load(path, schema) end

---Checks a table of any origin and returns a copy with the defaults filled in.
---@param data table
---@param schema table
---@return table checked
function cairn.data.check(data, schema) end

cairn.level = {}

---@class cairn.level.load.Fields
---@field scale? number at least 0; m per pixel, of maps of Tiled; absent: one tile is one metre wide

---Reads a level, or a map of Tiled, as data: nothing in it is run. Faults are an error with a line for each, such as `levels/one.lua:14:9: bodies[3].radius = -1: must be above 0 and at most 1000000`.
---@param path string
---@param fields cairn.level.load.Fields?
---@return Level level
function cairn.level.load(path, fields) end

---@class cairn.level.check.Fields
---@field scale? number at least 0; m per pixel, of maps of Tiled; absent: one tile is one metre wide

---A list of all that is wrong with a level; empty when it is good.
---@param path string
---@param fields cairn.level.check.Fields?
---@return string[] faults
function cairn.level.check(path, fields) end

---@class Level
local Level = {}

---Makes its bodies, triggers, prefabs and joints, in the order of the file. What it made before goes: calling it again starts the level anew.
---@param world World
function Level:build(world) end

---Destroys what `build` made and still lives.
function Level:clear() end

---@return boolean built
function Level:is_built() end

---Reads the file again. Parts that say what they said keep their state, the others are made anew, and with a joint the bodies that it holds. A level that is not built is only read: 0, 0. With a fault in the file nothing changes but that the error is raised.
---@return integer kept
---@return integer made
function Level:reload() end

---An unknown name is an error. The body may be destroyed by now.
---@param name string
---@return Body body
function Level:body(name) end

---The static body whose sensor it is: `sensor` in `world:sensor_events()`.
---@param name string
---@return Body body
function Level:trigger(name) end

---@param name string
---@return Prefab prefab
function Level:prefab(name) end

---@param name string
---@return Joint joint
function Level:joint(name) end

---A new list of those of `bodies` that live, in the order of the file.
---@return table bodies
function Level:bodies() end

---A place by its name.
---@param name string
---@return number x [m]
---@return number y [m]
---@return number angle [rad]
function Level:spawn(name) end

---nil when the level has none.
---@return number? x [m]
---@return number y [m]
---@return number height [m]
function Level:camera() end

---nil when the level has none.
---@return number? left [m]
---@return number bottom [m]
---@return number right [m]
---@return number top [m]
function Level:bounds() end

---What players call it; may be empty.
---@return string name
function Level:name() end

---@return string path
function Level:path() end

---A new table: the level's `data`, or an empty one.
---@return table data
function Level:data() end

---A new table with all that the file says.
---@return table table
function Level:table() end

---The level's file and those that it includes.
---@return string[] paths
function Level:files() end

---Draws the decorations of a layer, "back" or "front"; only in `cairn.draw`, under a camera.
---@param layer string?
function Level:draw(layer) end

cairn.test = {}

---Adds a test: `body()` runs in a fresh state and fails by raising an error. No two tests of a file have the same name.
---@param name string
---@param body function
function cairn.test.test(name, body) end

---@class cairn.test.start.Fields
---@field seed? integer of the gameplay stream

---Runs main.lua and `cairn.load`.
---@param fields cairn.test.start.Fields?
function cairn.test.start(fields) end

---Runs that many updates. Now and then, and when the test is over, `cairn.draw` is called too: a test whose game cannot be drawn fails.
---@param frames integer at least 0
function cairn.test.run(frames) end

---Runs updates until `condition()` is true; false when it never was.
---@param condition function
---@param max_frames integer at least 0
---@return boolean reached
function cairn.test.run_until(condition, max_frames) end

---Input of the next frame.
---@param key string
function cairn.test.press(key) end

---@param key string
function cairn.test.release(key) end

---Enters text as a keyboard does, character by character (UTF-8): for `cairn.text_input` and text fields. A text field takes it once it has been opened, as a player does: with the focus on it, `press("return")` and one frame, or a click. Keys such as "backspace" are pressed with `press`.
---@param text string
function cairn.test.type_text(text) end

---@param x number [px]
---@param y number [px]
function cairn.test.mouse_move(x, y) end

---@param x number [px]
---@param y number [px]
---@param button string?
function cairn.test.mouse_press(x, y, button) end

---@param x number [px]
---@param y number [px]
---@param button string?
function cairn.test.mouse_release(x, y, button) end

---@param dx number
---@param dy number
function cairn.test.wheel(dx, dy) end

---@param gamepad integer from 1 to 8
function cairn.test.gamepad_connect(gamepad) end

---@param gamepad integer from 1 to 8
function cairn.test.gamepad_disconnect(gamepad) end

---@param gamepad integer from 1 to 8
---@param button string
function cairn.test.gamepad_press(gamepad, button) end

---@param gamepad integer from 1 to 8
---@param button string
function cairn.test.gamepad_release(gamepad, button) end

---@param gamepad integer from 1 to 8
---@param axis string
---@param value number from -1 to 1
function cairn.test.gamepad_move(gamepad, axis, value) end

---Fingers are numbered from 1; as on a device the first is the left mouse button too.
---@param touch integer from 1 to 10
---@param x number [px]
---@param y number [px]
function cairn.test.touch_press(touch, x, y) end

---@param touch integer from 1 to 10
---@param x number [px]
---@param y number [px]
function cairn.test.touch_move(touch, x, y) end

---@param touch integer from 1 to 10
---@param x number [px]
---@param y number [px]
function cairn.test.touch_release(touch, x, y) end

---Fails unless the condition is true.
---@param condition any
---@param message string?
function cairn.test.expect(condition, message) end

---By `==`.
---@param actual any
---@param expected any
function cairn.test.expect_equal(actual, expected) end

---@param actual number
---@param expected number
---@param tolerance number at least 0
function cairn.test.expect_near(actual, expected, tolerance) end

---`action()` must raise an error whose message contains the text.
---@param action function
---@param text string
function cairn.test.expect_error(action, text) end

---@class cairn.test.expect_picture.Fields
---@field tolerance? number from 0 to 1; how far a color may be off
---@field share? number from 0 to 1; of the pixels that may be farther off

---What the game draws now must look like the picture, a PNG file of the game such as `tests/pictures/start.png`. `cairn test GAME --approve-pictures` writes it; where they differ, the new picture and one of the differences are kept, and the message tells where.
---@param path string
---@param fields cairn.test.expect_picture.Fields?
function cairn.test.expect_picture(path, fields) end

---What `cairn.result` reported last, or nil.
---@return table? result
function cairn.test.result() end

---That of `--hash`: all worlds and the gameplay stream.
---@return string hash
function cairn.test.state_hash() end

---Plays a recording of the game to its end, in a state of its own; a hash that differs is an error.
---@param path string
---@return table? result
function cairn.test.play_replay(path) end

---The run since `start` as the text of a replay.
---@return string text
function cairn.test.recording() end

---@type Random
cairn.random.visual = nil
---@type string
cairn.version = nil
