-- C++ keeps the list of the pairs that it has connected. A script keeps no list, so this one finds out which pairs
-- there were from the contacts that have begun and ended since. That is right for up to two neighbours of a sensor;
-- with three, which of them the others were connected to would depend on the order of objects, which no script sees.
local function conducts(object)
  return alive(object) and object.conductor ~= nil
end
local function contains(pairs_, pair)
  for _, other in ipairs(pairs_) do
    if same(other.a, pair.a) and same(other.b, pair.b) then
      return true
    end
  end
  return false
end
local function addNeighbours(list, sensor, pairs_, except)
  for _, pair in ipairs(pairs_) do
    local other = same(pair.a, sensor) and pair.b or same(pair.b, sensor) and pair.a or nil
    if other and conducts(other) and not contains(except, pair) then
      list[#list + 1] = other
    end
  end
  return list
end
-- The pairs that a sensor connects while it hears enough, now or a turn ago.
local function links(object, before)
  local sensor = object.sound_sensor
  if sensor.from or sensor.to then
    local both = conducts(sensor.from) and conducts(sensor.to) and not same(sensor.from, sensor.to)
    return both and { { a = sensor.from, b = sensor.to } } or {}
  end
  local contacts = world.contacts
  local near = addNeighbours({}, object, contacts.current, before and contacts.begun or {})
  if before then
    addNeighbours(near, object, contacts.ended, {})
  end
  local made = {}
  for i = 2, #near do
    made[i - 1] = { a = near[1], b = near[i] }
  end
  return made
end
local function isAmong(made, link)
  for _, other in ipairs(made) do
    if same(other.a, link.a) and same(other.b, link.b) or same(other.a, link.b) and same(other.b, link.a) then
      return true
    end
  end
  return false
end

return interaction {
  name = "Electricity <- Sound",
  text = "Connects, while a sensor hears enough, the two conductors that it names, or all that touch it, and "
    .. "disconnects them when it no longer does.",
  calls = "Electricity",
  reads = { "loudness", "sound_sensor", "contacts", "conductor" },
  each = { "sound_sensor" },
  store = { object = { heard = false } },
  apply = function(object, params, out, store)
    local hears = false
    for _, entry in ipairs(world.loudness.entries) do
      hears = hears or same(entry.object, object) and entry.level >= object.sound_sensor.threshold_db
    end
    local before = store.object.heard and links(object, true) or {}
    local now = hears and links(object, false) or {}
    for _, link in ipairs(before) do
      if not isAmong(now, link) then
        out.removeConnection(link.a, link.b)
      end
    end
    for _, link in ipairs(now) do
      if not isAmong(before, link) then
        out.addConnection(link.a, link.b)
      end
    end
    store.object.heard = hears
  end,
}
