-- The player's hand is a property like any other: it says which object is held. So this tool works with a mouse, in a
-- replay and in a recorded solution alike.
--
-- Objects cannot be kept in the store, as they may be gone in the next frame; their names can.
local near = 0.25   -- m, the distance from the grip's point at which a thing is caught
local stiffness = 12 -- 1/s, of the springs that hold what is caught, and the gun's direction; critically damped
local gyration = 0.05 -- m^2, moment of inertia over mass, about that of a gun

return interaction {
  name = "Dynamics <- Gravity gun",
  text = "While the player holds a gravity gun, it draws in what lies in the cone before its muzzle, keeps hold of the "
    .. "first thing that comes near, and keeps its own direction. When the player lets the gun go, it hurls that thing "
    .. "away. Each force on a thing has its reaction on the gun.",
  calls = "Dynamics",
  reads = { "Name", "Position", "Rotation", "Velocity", "Angular Velocity", "Mass", "Fixed", "Gravity", "Hand" },
  attached = true,
  pairs = { first = { "Position", "Rotation", "Velocity", "Angular Velocity", "Mass" },
            second = { "Name", "Position", "Velocity", "Mass" }, within = "reach" },
  params = {
    reach = { default = 3, min = 0, max = 100, unit = "m", text = "How far it draws" },
    half_angle = { default = 25, min = 0, max = 180, unit = "degrees", text = "From the middle of its cone to the edge" },
    pull = { default = 25, min = 0, max = 1000, unit = "m/s²", text = "How strongly it draws" },
    muzzle = { default = 0.6, min = 0, max = 10, unit = "m", text = "How far before its centre it keeps what it has caught" },
    launch = { default = 9, min = 0, max = 200, unit = "m/s", text = "How fast it hurls" },
  },
  store = { object = { caught = "", aim = 0, waiting = 0 } },
  apply = function(gun, body, params, out, store, frame)
    if body.Fixed then return end
    local ahead = vec2(1, 0):turned(gun.Rotation.value)
    local name = body.Name.value
    local mass = body.Mass.value
    local held = world.Hand.object
    if held == nil or not same(held, gun) then
      if store.object.caught == name then
        store.object.caught = ""
        local impulse = ahead * (mass * params.launch)
        out.addImpulse(body, body.Position.value, impulse)
        out.addImpulse(gun, gun.Position.value, -impulse)
      elseif store.object.caught ~= "" then -- perhaps it is gone
        store.object.waiting = store.object.waiting + frame.duration
        if store.object.waiting > 1 then
          store.object.caught = ""
          store.object.waiting = 0
        end
      end
      store.object.aim = gun.Rotation.value -- the last one before it is taken is the one that it keeps
      return
    end
    local grip = gun.Position.value + ahead * params.muzzle
    local way = grip - body.Position.value
    if store.object.caught == "" and way:length() < near then
      store.object.caught = name
    end
    local force
    if store.object.caught == name then
      local relative = gun.Velocity.value - body.Velocity.value
      force = (way * (stiffness * stiffness) + relative * (2 * stiffness)) * mass
      if world.Gravity then force = force - world.Gravity.value * mass end
      out.tellRate(body, stiffness, false, true)
      local turn = (store.object.aim - gun.Rotation.value) * (stiffness * stiffness)
        - gun["Angular Velocity"].value * (2 * stiffness)
      out.addTorque(gun, turn * gyration * gun.Mass.value)
    elseif store.object.caught == "" then
      local aside = body.Position.value - gun.Position.value
      if aside:dot(ahead) < aside:length() * math.cos(math.rad(params.half_angle)) then return end
      force = way:unit() * (params.pull * mass)
      out.tellRate(body, math.sqrt(params.pull / near), false, true)
    else
      return
    end
    out.addForce(body, force)
    out.addForce(gun, -force)
  end,
}
