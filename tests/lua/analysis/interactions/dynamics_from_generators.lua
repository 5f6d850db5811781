-- Area (m^2), centre (m) and square of the radius of gyration (m^2) of shapes: what C++ interactions ask the
-- function massPropertiesOf() for, term by term in the same order.
local function ofPolygon(corners)
  local origin = corners[1]
  local area, moment, centre = 0, 0, vec2(0, 0)
  for i = 2, #corners - 1 do
    local p, q = corners[i] - origin, corners[i + 1] - origin
    local part = p:cross(q) / 2
    area = area + part
    centre = centre + part / 3 * (p + q)
    moment = moment + part / 6 * (p:dot(p) + p:dot(q) + q:dot(q))
  end
  centre = centre * (1 / area)
  return area, centre + origin, moment / area - centre:dot(centre)
end
local function ofCapsule(width, radius)
  local half = width / 2 - radius
  local box = 4 * half * radius
  local disc = math.pi * radius * radius
  local offset = 4 * radius / (3 * math.pi)
  local boxMoment = box * (half * half + radius * radius) / 3
  local discMoment = disc * (radius * radius / 2 - offset * offset + (half + offset) * (half + offset))
  return box + disc, vec2(0, 0), (boxMoment + discMoment) / (box + disc)
end
local function inOwnFrame(piece)
  if piece.form == "circle" then
    return math.pi * piece.radius * piece.radius, vec2(0, 0), piece.radius * piece.radius / 2
  elseif piece.form == "box" then
    return piece.width * piece.height, vec2(0, 0),
      (piece.width * piece.width + piece.height * piece.height) / 12
  elseif piece.form == "capsule" then
    return ofCapsule(piece.width, piece.radius)
  end
  return ofPolygon(piece.corners)
end
local function massProperties(pieces)
  if #pieces == 1 and pieces[1].at == vec2(0, 0) and pieces[1].angle_deg == 0 then
    local _, centre, inertia = inOwnFrame(pieces[1])
    return centre, inertia
  end
  local area, centre, inertia = 0, vec2(0, 0), 0
  for _, piece in ipairs(pieces) do
    local own, middle = inOwnFrame(piece)
    area = area + own
    centre = centre + own * (piece.at + middle:turned(piece.angle_deg))
  end
  centre = centre * (1 / area)
  for _, piece in ipairs(pieces) do
    local own, middle, perMass = inOwnFrame(piece)
    local away = piece.at + middle:turned(piece.angle_deg) - centre
    inertia = inertia + own / area * (perMass + away:dot(away))
  end
  return centre, inertia
end

-- kg m^2; without end for what does not turn.
local function inertiaOf(object)
  if object == nil or object.fixed then
    return math.huge
  end
  if not object.mass or not object.shape or #object.shape.value == 0 then
    return 0
  end
  local _, perMass = massProperties(object.shape.value)
  return object.mass.value * perMass
end
local function speedOf(object)
  return object and object["Angular Velocity"] and object["Angular Velocity"].value or 0
end
local function isOn(object)
  for _, entry in ipairs(world.electrical_state.objects) do
    if entry.on and same(entry.object, object) then
      return true
    end
  end
  return false
end

return interaction {
  name = "Dynamics <- Generators",
  text = "Brakes every generator through which current flows.",
  calls = "Dynamics",
  reads = { "electrical_state", "generator", "Angular Velocity", "mass", "shape", "fixed" },
  each = { "generator" },
  apply = function(object, params, out, store, frame)
    if isOn(object) then
      local speed = speedOf(object)
      local most = math.min(object.generator.braking, inertiaOf(object) * math.abs(speed) / frame.duration)
      out.addTorque(object, speed < 0 and most or -most)
    end
  end,
}
